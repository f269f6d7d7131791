/** One connection to a bridge, and the topics behind it. */
package org.robotui.rfic.rosbridge.internal.session;
