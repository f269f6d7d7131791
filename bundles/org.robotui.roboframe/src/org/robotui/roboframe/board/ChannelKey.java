package org.robotui.roboframe.board;

import java.util.regex.Pattern;
import org.robotui.message.DynamicCodec;
import org.robotui.message.DynamicMessage;
import org.robotui.message.MessageCodec;
import org.robotui.message.MessageSchema;
import org.robotui.message.RecordCodec;

/**
 * The identifier of a channel, and what it carries.
 *
 * @param name letters, digits and {@code _ - . /}, such as {@code laser/scan}
 * @param codec makes bytes of values and back
 * @param every whether every value counts; else only the newest does
 * @param <T> the values
 */
public record ChannelKey<T>(String name, MessageCodec<T> codec, boolean every) {

  private static final Pattern NAME = Pattern.compile("[A-Za-z0-9_][A-Za-z0-9_.\\-/]{0,99}");

  /** Refuses what is no name with an {@link IllegalArgumentException}. */
  public ChannelKey {
    if (!NAME.matcher(name).matches()) {
      throw new IllegalArgumentException("'" + name
          + "' is no name of a key; write 1 to 100 letters, digits and _ - . / such as laser/scan");
    }
  }

  /**
   * Of a record that is shipped with its definition.
   *
   * @param name of the key
   * @param type a record with a {@code MessageType}
   * @param <T> the record
   * @return a key of which the newest value counts
   */
  public static <T extends Record> ChannelKey<T> of(String name, Class<T> type) {
    return new ChannelKey<>(name, RecordCodec.of(type), false);
  }

  /**
   * Of any type by its definition.
   *
   * @param name of the key
   * @param schema of its values
   * @return a key of which the newest value counts
   */
  public static ChannelKey<DynamicMessage> of(String name, MessageSchema schema) {
    return new ChannelKey<>(name, new DynamicCodec(schema), false);
  }

  /**
   * The same where every value counts.
   *
   * @return such a key
   */
  public ChannelKey<T> ofEvery() {
    return new ChannelKey<>(name, codec, true);
  }
}
