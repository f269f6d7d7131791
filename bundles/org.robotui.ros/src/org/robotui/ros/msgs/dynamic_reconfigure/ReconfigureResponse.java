package org.robotui.ros.msgs.dynamic_reconfigure;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * Answers a request for other values ({@code dynamic_reconfigure/ReconfigureResponse}).
 *
 * @param config all values as they are now
 */
public record ReconfigureResponse(Config config) {

  /** Between records and bytes. */
  public static final RecordCodec<ReconfigureResponse> CODEC =
      RecordCodec.of("dynamic_reconfigure/ReconfigureResponse", ReconfigureResponse::read, ReconfigureResponse::write);

  private static ReconfigureResponse read(MessageReader in) throws MessageException {
    return new ReconfigureResponse(in.nested("config", Config.CODEC));
  }

  private static void write(ReconfigureResponse m, MessageWriter out) {
    Config.CODEC.encode(m.config, out);
  }
}
