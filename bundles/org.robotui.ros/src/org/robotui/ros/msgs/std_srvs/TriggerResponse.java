package org.robotui.ros.msgs.std_srvs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * Answers a trigger ({@code std_srvs/TriggerResponse}).
 *
 * @param success whether it was done
 * @param message why not, or what was done
 */
public record TriggerResponse(boolean success, String message) {

  /** Between records and bytes. */
  public static final RecordCodec<TriggerResponse> CODEC =
      RecordCodec.of("std_srvs/TriggerResponse", TriggerResponse::read, TriggerResponse::write);

  private static TriggerResponse read(MessageReader in) throws MessageException {
    return new TriggerResponse(in.bool("success"), in.string("message"));
  }

  private static void write(TriggerResponse m, MessageWriter out) {
    out.bool(m.success);
    out.string(m.message);
  }
}
