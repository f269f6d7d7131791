/** Robots that speak LCM: channels become ports, by listening. */
package org.robotui.rfic.lcm.internal;
