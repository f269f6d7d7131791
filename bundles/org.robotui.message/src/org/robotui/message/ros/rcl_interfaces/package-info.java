/**
 * The messages of the ROS package {@code rcl_interfaces} as records. For speed, arrays and byte buffers are shared with
 * whoever made the record or the bytes it was decoded from: nobody changes their elements.
 */
package org.robotui.message.ros.rcl_interfaces;
