/**
 * How messages of ROS become data types and back, whichever generation and encoding they came in:
 * {@link org.robotui.message.data.Adapters} knows the conversion of each message type,
 * {@link org.robotui.message.data.CommandType} the messages of commands. They see records and
 * {@link org.robotui.message.DynamicMessage}, never bytes; who reads the bytes binds them by
 * {@link org.robotui.message.data.MessageForm}.
 */
@org.osgi.annotation.versioning.Version("2.1.0")
package org.robotui.message.data;
