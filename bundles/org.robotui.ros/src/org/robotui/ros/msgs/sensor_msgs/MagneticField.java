package org.robotui.ros.msgs.sensor_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.geometry_msgs.Vector3;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * A magnetic field ({@code sensor_msgs/MagneticField}).
 *
 * @param header                  time and frame
 * @param magneticField           teslas
 * @param magneticFieldCovariance 3 x 3, row by row, 0 if not known
 */
public record MagneticField(Header header, Vector3 magneticField, double[] magneticFieldCovariance) {

  /** Between records and bytes. */
  public static final RecordCodec<MagneticField> CODEC =
      RecordCodec.of("sensor_msgs/MagneticField", MagneticField::read, MagneticField::write);

  /** Checks the lengths of fixed arrays. */
  public MagneticField {
    RecordCodec.requireLength("magnetic_field_covariance", magneticFieldCovariance.length, 9);
  }

  private static MagneticField read(MessageReader in) throws MessageException {
    return new MagneticField(
        in.nested("header", Header.CODEC),
        in.nested("magnetic_field", Vector3.CODEC),
        in.doubles("magnetic_field_covariance", 9));
  }

  private static void write(MagneticField m, MessageWriter out) {
    Header.CODEC.encode(m.header, out);
    Vector3.CODEC.encode(m.magneticField, out);
    out.doubles(m.magneticFieldCovariance);
  }
}
