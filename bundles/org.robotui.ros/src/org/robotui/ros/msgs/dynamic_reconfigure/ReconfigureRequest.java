package org.robotui.ros.msgs.dynamic_reconfigure;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * Asks for other values ({@code dynamic_reconfigure/ReconfigureRequest}).
 *
 * @param config what is to change
 */
public record ReconfigureRequest(Config config) {

  /** Between records and bytes. */
  public static final RecordCodec<ReconfigureRequest> CODEC =
      RecordCodec.of("dynamic_reconfigure/ReconfigureRequest", ReconfigureRequest::read, ReconfigureRequest::write);

  private static ReconfigureRequest read(MessageReader in) throws MessageException {
    return new ReconfigureRequest(in.nested("config", Config.CODEC));
  }

  private static void write(ReconfigureRequest m, MessageWriter out) {
    Config.CODEC.encode(m.config, out);
  }
}
