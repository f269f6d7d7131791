package org.robotui.ros.msgs.sensor_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.geometry_msgs.Quaternion;
import org.robotui.ros.msgs.geometry_msgs.Vector3;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * Reading of an inertial measurement unit ({@code sensor_msgs/Imu}).
 *
 * @param header                       time and frame
 * @param orientation                  the orientation
 * @param orientationCovariance        3 x 3, row by row; all zero if not known, first value -1 if there is no
 *                                     orientation
 * @param angularVelocity              radians per second
 * @param angularVelocityCovariance    3 x 3, row by row; as above
 * @param linearAcceleration           metres per second squared
 * @param linearAccelerationCovariance 3 x 3, row by row; as above
 */
public record Imu(
    Header header, Quaternion orientation, double[] orientationCovariance, Vector3 angularVelocity, double[]
    angularVelocityCovariance, Vector3 linearAcceleration, double[] linearAccelerationCovariance) {

  /** Between records and bytes. */
  public static final RecordCodec<Imu> CODEC =
      RecordCodec.of("sensor_msgs/Imu", Imu::read, Imu::write);

  /** Checks the lengths of fixed arrays. */
  public Imu {
    RecordCodec.requireLength("orientation_covariance", orientationCovariance.length, 9);
    RecordCodec.requireLength("angular_velocity_covariance", angularVelocityCovariance.length, 9);
    RecordCodec.requireLength("linear_acceleration_covariance", linearAccelerationCovariance.length, 9);
  }

  private static Imu read(MessageReader in) throws MessageException {
    return new Imu(
        in.nested("header", Header.CODEC),
        in.nested("orientation", Quaternion.CODEC),
        in.doubles("orientation_covariance", 9),
        in.nested("angular_velocity", Vector3.CODEC),
        in.doubles("angular_velocity_covariance", 9),
        in.nested("linear_acceleration", Vector3.CODEC),
        in.doubles("linear_acceleration_covariance", 9));
  }

  private static void write(Imu m, MessageWriter out) {
    Header.CODEC.encode(m.header, out);
    Quaternion.CODEC.encode(m.orientation, out);
    out.doubles(m.orientationCovariance);
    Vector3.CODEC.encode(m.angularVelocity, out);
    out.doubles(m.angularVelocityCovariance);
    Vector3.CODEC.encode(m.linearAcceleration, out);
    out.doubles(m.linearAccelerationCovariance);
  }
}
