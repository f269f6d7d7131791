package org.robotui.api.port;

import java.util.Optional;
import org.robotui.data.record.FieldPath;

/**
 * A field of what a stream gives, as users write it: {@code base./odom:linear.x}.
 *
 * @param source component and port
 * @param path of the field
 */
public record StreamField(SourceId source, FieldPath path) {
  /**
   * Reads one.
   *
   * @param text {@code COMPONENT.PORT:PATH}; the port may have colons
   * @return none where it is not of that form
   * @throws IllegalArgumentException where the path is none; the message says what is wrong with it
   */
  public static Optional<StreamField> read(String text) {
    int colon = text.lastIndexOf(':');
    int dot = text.indexOf('.');
    if (dot <= 0 || colon < dot + 2 || colon == text.length() - 1) {
      return Optional.empty();
    }
    return Optional.of(new StreamField(new SourceId(text.substring(0, dot), text.substring(dot + 1, colon)),
        FieldPath.parse(text.substring(colon + 1))));
  }

  /**
   * Reads one that a setting holds.
   *
   * @param text as {@link #read}
   * @return the field
   * @throws IllegalArgumentException where it is none; the message says what would be one
   */
  public static StreamField parse(String text) {
    return read(text).orElseThrow(() -> new IllegalArgumentException(
        "'" + text + "' names no field; write SOURCE:PATH, for example base./odom:linear.x"));
  }

  @Override
  public String toString() {
    return source + ":" + path;
  }
}
