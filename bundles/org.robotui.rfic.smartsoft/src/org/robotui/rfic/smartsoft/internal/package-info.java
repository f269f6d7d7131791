/** The robot interface to SmartSoft: services that a naming service knows become ports. */
package org.robotui.rfic.smartsoft.internal;
