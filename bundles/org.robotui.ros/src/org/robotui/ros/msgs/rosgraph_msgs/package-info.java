/**
 * The messages of the ROS package {@code rosgraph_msgs} as records. Arrays and byte buffers are shared with the decoded message
 * for speed: nobody changes their elements. Records with a fixed array or a list check and copy it at construction.
 */
package org.robotui.ros.msgs.rosgraph_msgs;
