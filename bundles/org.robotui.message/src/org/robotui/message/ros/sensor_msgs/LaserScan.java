package org.robotui.message.ros.sensor_msgs;

import org.robotui.message.MessageType;
import org.robotui.message.ros.std_msgs.Header;

/**
 * One sweep of a planar laser scanner ({@code sensor_msgs/LaserScan}).
 *
 * @param header when the first ray was taken, and the frame: rays lie in its x-y plane
 * @param angleMin angle of the first ray, radians
 * @param angleMax angle of the last ray, radians
 * @param angleIncrement from ray to ray, radians
 * @param timeIncrement from ray to ray, seconds
 * @param scanTime from sweep to sweep, seconds
 * @param rangeMin shortest valid distance, metres
 * @param rangeMax longest valid distance, metres
 * @param ranges a distance for each ray, metres; outside the limits it is invalid
 * @param intensities an echo strength for each ray in the device's unit, or empty
 */
@MessageType("sensor_msgs/LaserScan")
public record LaserScan(
    Header header, float angleMin, float angleMax, float angleIncrement, float timeIncrement, float scanTime,
    float rangeMin, float rangeMax, float[] ranges, float[] intensities) {}
