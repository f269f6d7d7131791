package org.robotui.ros.msgs.diagnostic_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * A named value ({@code diagnostic_msgs/KeyValue}).
 *
 * @param key   the name
 * @param value the value as text
 */
public record KeyValue(String key, String value) {

  /** Between records and bytes. */
  public static final RecordCodec<KeyValue> CODEC =
      RecordCodec.of("diagnostic_msgs/KeyValue", KeyValue::read, KeyValue::write);

  private static KeyValue read(MessageReader in) throws MessageException {
    return new KeyValue(in.string("key"), in.string("value"));
  }

  private static void write(KeyValue m, MessageWriter out) {
    out.string(m.key);
    out.string(m.value);
  }
}
