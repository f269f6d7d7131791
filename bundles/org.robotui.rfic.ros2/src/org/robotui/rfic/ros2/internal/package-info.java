/** The robot interface to ROS 2: topics become ports, by discovery. */
package org.robotui.rfic.ros2.internal;
