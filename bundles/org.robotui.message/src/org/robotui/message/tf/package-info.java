/**
 * Transforms between coordinate frames as both generations of ROS send them, and how they come into a
 * {@link org.robotui.geometry.TransformBuffer}. Frames are named without the leading slash that old senders add.
 */
package org.robotui.message.tf;
