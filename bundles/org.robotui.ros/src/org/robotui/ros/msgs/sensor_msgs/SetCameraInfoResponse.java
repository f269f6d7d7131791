package org.robotui.ros.msgs.sensor_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * Answers the request to store a calibration ({@code sensor_msgs/SetCameraInfoResponse}).
 *
 * @param success       whether it was stored
 * @param statusMessage why not, or what was done
 */
public record SetCameraInfoResponse(boolean success, String statusMessage) {

  /** Between records and bytes. */
  public static final RecordCodec<SetCameraInfoResponse> CODEC =
      RecordCodec.of("sensor_msgs/SetCameraInfoResponse", SetCameraInfoResponse::read, SetCameraInfoResponse::write);

  private static SetCameraInfoResponse read(MessageReader in) throws MessageException {
    return new SetCameraInfoResponse(in.bool("success"), in.string("status_message"));
  }

  private static void write(SetCameraInfoResponse m, MessageWriter out) {
    out.bool(m.success);
    out.string(m.statusMessage);
  }
}
