/** The robot interface to ROS 1: topics become ports, by discovery. */
package org.robotui.rfic.ros.internal;
