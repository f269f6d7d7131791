package org.robotui.ros.msgs.std_srvs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * Switches something on or off ({@code std_srvs/SetBoolRequest}).
 *
 * @param data on or off
 */
public record SetBoolRequest(boolean data) {

  /** Between records and bytes. */
  public static final RecordCodec<SetBoolRequest> CODEC =
      RecordCodec.of("std_srvs/SetBoolRequest", SetBoolRequest::read, SetBoolRequest::write);

  private static SetBoolRequest read(MessageReader in) throws MessageException {
    return new SetBoolRequest(in.bool("data"));
  }

  private static void write(SetBoolRequest m, MessageWriter out) {
    out.bool(m.data);
  }
}
