/**
 * Coordinate frames over ROS: transforms of {@code /tf} and {@code /tf_static} into a
 * {@link org.robotui.geometry.TransformBuffer} and out to other nodes. Frames are named without the leading slash that
 * old senders add.
 */
package org.robotui.ros.tf;
