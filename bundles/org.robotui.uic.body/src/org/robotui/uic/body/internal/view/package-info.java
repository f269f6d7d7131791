/** What is seen of a body. */
package org.robotui.uic.body.internal.view;
