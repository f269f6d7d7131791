/**
 * The standard message and service types as records: one Java package for each ROS package, one record for each message
 * type. Times are nanoseconds ({@link org.robotui.message.Stamps}); unsigned 32-bit integers are {@code long}; byte
 * arrays are slices of the received message.
 */
package org.robotui.ros.msgs;
