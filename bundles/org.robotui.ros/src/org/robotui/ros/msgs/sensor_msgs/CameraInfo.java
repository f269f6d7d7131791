package org.robotui.ros.msgs.sensor_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * Calibration of a camera ({@code sensor_msgs/CameraInfo}).
 *
 * @param header          time of the image and optical frame
 * @param height          rows of the calibrated image
 * @param width           columns of the calibrated image
 * @param distortionModel such as {@code plumb_bob}
 * @param d               distortion coefficients
 * @param k               3 x 3 intrinsic matrix of the raw image, row by row
 * @param r               3 x 3 rectification matrix, row by row
 * @param p               3 x 4 projection matrix, row by row
 * @param binningX        columns joined into one; 0 means 1
 * @param binningY        rows joined into one; 0 means 1
 * @param roi             part of the full image; all zero means all of it
 */
public record CameraInfo(
    Header header, long height, long width, String distortionModel, double[] d, double[] k, double[] r, double[]
    p, long binningX, long binningY, RegionOfInterest roi) {

  /** Between records and bytes. */
  public static final RecordCodec<CameraInfo> CODEC =
      RecordCodec.of("sensor_msgs/CameraInfo", CameraInfo::read, CameraInfo::write);

  /** Checks the lengths of fixed arrays. */
  public CameraInfo {
    RecordCodec.requireLength("K", k.length, 9);
    RecordCodec.requireLength("R", r.length, 9);
    RecordCodec.requireLength("P", p.length, 12);
  }

  private static CameraInfo read(MessageReader in) throws MessageException {
    return new CameraInfo(
        in.nested("header", Header.CODEC),
        in.uint32("height"),
        in.uint32("width"),
        in.string("distortion_model"),
        in.doubles("D", in.count("D", 8)),
        in.doubles("K", 9),
        in.doubles("R", 9),
        in.doubles("P", 12),
        in.uint32("binning_x"),
        in.uint32("binning_y"),
        in.nested("roi", RegionOfInterest.CODEC));
  }

  private static void write(CameraInfo m, MessageWriter out) {
    Header.CODEC.encode(m.header, out);
    out.i32((int) m.height);
    out.i32((int) m.width);
    out.string(m.distortionModel);
    out.array(m.d.length).doubles(m.d);
    out.doubles(m.k);
    out.doubles(m.r);
    out.doubles(m.p);
    out.i32((int) m.binningX);
    out.i32((int) m.binningY);
    RegionOfInterest.CODEC.encode(m.roi, out);
  }
}
