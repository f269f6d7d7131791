package org.robotui.message.ros.sensor_msgs;

import org.robotui.message.MessageType;
import org.robotui.message.ros.geometry_msgs.Quaternion;
import org.robotui.message.ros.geometry_msgs.Vector3;
import org.robotui.message.ros.std_msgs.Header;

/**
 * Reading of an inertial measurement unit ({@code sensor_msgs/Imu}).
 *
 * @param header time and frame
 * @param orientation the orientation
 * @param orientationCovariance 3 x 3, row by row; all zero if not known, first value -1 if there is no orientation
 * @param angularVelocity radians per second
 * @param angularVelocityCovariance 3 x 3, row by row; as above
 * @param linearAcceleration metres per second squared
 * @param linearAccelerationCovariance 3 x 3, row by row; as above
 */
@MessageType("sensor_msgs/Imu")
public record Imu(
    Header header, Quaternion orientation, double[] orientationCovariance, Vector3 angularVelocity,
    double[] angularVelocityCovariance, Vector3 linearAcceleration, double[] linearAccelerationCovariance) {}
