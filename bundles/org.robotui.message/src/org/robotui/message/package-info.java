/**
 * What a message of ROS 1 or ROS 2 is: its identity ({@link org.robotui.message.MessageInfo}), its definition
 * ({@link org.robotui.message.MessageSchema}), and codecs between its bytes and a Java value
 * ({@link org.robotui.message.MessageCodec}): those of records that are bound to their definition
 * ({@link org.robotui.message.RecordCodec}), and those that work from a definition
 * ({@link org.robotui.message.AnyCodec}, {@link org.robotui.message.DynamicCodec}).
 *
 * <p>Bytes and definitions come from peers and are not trusted: every length is checked against what is there before
 * anything is allocated, and errors name the field.
 */
package org.robotui.message;
