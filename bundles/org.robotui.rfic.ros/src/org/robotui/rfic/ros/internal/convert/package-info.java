/** Turns ROS messages into data and commands into ROS messages. */
package org.robotui.rfic.ros.internal.convert;
