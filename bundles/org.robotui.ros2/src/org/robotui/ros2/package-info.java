/**
 * ROS 2 in pure Java, usable alone: contexts and nodes ({@link org.robotui.ros2.Ros2Context},
 * {@link org.robotui.ros2.Ros2Node}), topics, services, clocks, and types without their sources
 * ({@link org.robotui.ros2.Ros2Types}). It stands on {@link org.robotui.rtps} and needs no installation of ROS.
 *
 * <p>Messages are delivered on the receiving thread of the context, which must not be blocked; calls of services of
 * this process are answered on threads of their own. Whatever waits says so.
 */
package org.robotui.ros2;
