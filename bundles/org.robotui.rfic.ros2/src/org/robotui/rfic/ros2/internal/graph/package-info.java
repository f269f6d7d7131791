/** Follows the ROS graph and keeps the offered ports equal to it. */
package org.robotui.rfic.ros2.internal.graph;
