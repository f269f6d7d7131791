/** The few words by which a configuration says where in a message something stands, and in which unit. */
package org.robotui.rfic.lcm.internal.language;
