/** Messages that only this library sends and reads, as they are on the wire. */
package org.robotui.ros2.internal.msgs;
