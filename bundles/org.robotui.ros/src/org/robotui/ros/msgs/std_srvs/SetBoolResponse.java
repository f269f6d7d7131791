package org.robotui.ros.msgs.std_srvs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * Answers a switch ({@code std_srvs/SetBoolResponse}).
 *
 * @param success whether it was done
 * @param message why not, or what was done
 */
public record SetBoolResponse(boolean success, String message) {

  /** Between records and bytes. */
  public static final RecordCodec<SetBoolResponse> CODEC =
      RecordCodec.of("std_srvs/SetBoolResponse", SetBoolResponse::read, SetBoolResponse::write);

  private static SetBoolResponse read(MessageReader in) throws MessageException {
    return new SetBoolResponse(in.bool("success"), in.string("message"));
  }

  private static void write(SetBoolResponse m, MessageWriter out) {
    out.bool(m.success);
    out.string(m.message);
  }
}
