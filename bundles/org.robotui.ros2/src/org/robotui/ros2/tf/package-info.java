/**
 * Coordinate frames over ROS 2: transforms of {@code /tf} and {@code /tf_static} into a
 * {@link org.robotui.geometry.TransformBuffer}, and out to other nodes.
 */
package org.robotui.ros2.tf;
