/** The type roblets: settings and sessions. */
package org.robotui.rfic.roblets.internal;
