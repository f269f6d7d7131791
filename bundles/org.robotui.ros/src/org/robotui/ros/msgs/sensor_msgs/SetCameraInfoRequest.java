package org.robotui.ros.msgs.sensor_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * Stores a calibration in a camera ({@code sensor_msgs/SetCameraInfoRequest}).
 *
 * @param cameraInfo the calibration
 */
public record SetCameraInfoRequest(CameraInfo cameraInfo) {

  /** Between records and bytes. */
  public static final RecordCodec<SetCameraInfoRequest> CODEC =
      RecordCodec.of("sensor_msgs/SetCameraInfoRequest", SetCameraInfoRequest::read, SetCameraInfoRequest::write);

  private static SetCameraInfoRequest read(MessageReader in) throws MessageException {
    return new SetCameraInfoRequest(in.nested("camera_info", CameraInfo.CODEC));
  }

  private static void write(SetCameraInfoRequest m, MessageWriter out) {
    CameraInfo.CODEC.encode(m.cameraInfo, out);
  }
}
