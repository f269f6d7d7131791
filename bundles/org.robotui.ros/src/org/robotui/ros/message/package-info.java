/**
 * What a ROS message is to the transport: its identity ({@link org.robotui.ros.message.MessageInfo}) and a codec
 * between its bytes and a Java value ({@link org.robotui.ros.message.MessageCodec}).
 */
package org.robotui.ros.message;
