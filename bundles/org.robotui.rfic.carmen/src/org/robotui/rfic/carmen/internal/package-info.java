/** The robot interface to CARMEN: messages that a central knows become ports. */
package org.robotui.rfic.carmen.internal;
