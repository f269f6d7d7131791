package org.robotui.yarp.wire;

import java.util.Locale;
import java.util.Optional;

/**
 * What an envelope says.
 *
 * @param sequence counts messages
 * @param seconds since 1970 by the clock of who sent it; 0 where it has none
 */
public record YarpStamp(int sequence, double seconds) {

  /**
   * Reads an envelope.
   *
   * @param text count and time with a space between
   * @return empty where it is no envelope of numbers
   */
  public static Optional<YarpStamp> parse(String text) {
    String[] parts = text.strip().split(" +");
    try {
      return parts.length == 2
          ? Optional.of(new YarpStamp(Integer.parseInt(parts[0]), Double.parseDouble(parts[1])))
          : Optional.empty();
    } catch (NumberFormatException e) {
      return Optional.empty();
    }
  }

  /** As it stands in an envelope. */
  @Override
  public String toString() {
    return seconds == 0 ? sequence + " 0" : String.format(Locale.ROOT, "%d %.6f", sequence, seconds);
  }
}
