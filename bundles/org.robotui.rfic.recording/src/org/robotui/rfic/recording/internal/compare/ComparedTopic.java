package org.robotui.rfic.recording.internal.compare;

import java.util.Optional;
import org.robotui.data.record.FieldPath;

/**
 * What of two recordings is compared.
 *
 * @param first the name of a stream of the first recording
 * @param second that of the other recording
 * @param field a number in their values; none for where they say that something is
 */
public record ComparedTopic(String first, String second, Optional<FieldPath> field) {
  /**
   * Reads it.
   *
   * @param text {@code odom}, {@code odom,base_odometry} where names differ, or {@code odom linear.x}
   * @return what is meant
   * @throws IllegalArgumentException where it is none of these
   */
  public static ComparedTopic of(String text) {
    String[] words = text.strip().split("\\s+", 2);
    String[] names = words[0].split(",", -1);
    if (names.length > 2 || names[0].isEmpty() || names[names.length - 1].isEmpty()) {
      throw new IllegalArgumentException("'" + text + "' is neither a topic such as odom nor a topic of each recording,"
          + " such as odom,base_odometry, and for a number the name of its field, such as \"odom linear.x\"");
    }
    return new ComparedTopic(names[0], names[names.length - 1],
        words.length < 2 ? Optional.empty() : Optional.of(FieldPath.parse(words[1])));
  }

  @Override
  public String toString() {
    return (first.equals(second) ? first : first + "," + second) + field.map(path -> " " + path).orElse("");
  }
}
