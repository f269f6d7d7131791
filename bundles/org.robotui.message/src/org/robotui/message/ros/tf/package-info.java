/**
 * The messages of the ROS package {@code tf} as records. For speed, arrays and byte buffers are shared with whoever
 * made the record or the bytes it was decoded from: nobody changes their elements.
 */
package org.robotui.message.ros.tf;
