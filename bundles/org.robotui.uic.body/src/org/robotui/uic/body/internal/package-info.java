/** The view Body. */
package org.robotui.uic.body.internal;
