/** Turns ROS messages into data and commands into ROS messages. */
package org.robotui.rfic.ros2.internal.convert;
