/** Asking what there is, and saying single messages. */
package org.robotui.rfic.lcm.internal.call;
