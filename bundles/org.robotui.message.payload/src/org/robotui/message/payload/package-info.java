/**
 * Messages as the bytes that bridges send: of ROS in its encodings, and JSON, read by the definitions of ROS or by the
 * names of their fields, and written likewise.
 */
package org.robotui.message.payload;
