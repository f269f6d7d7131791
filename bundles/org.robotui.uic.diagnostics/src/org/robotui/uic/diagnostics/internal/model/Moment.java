package org.robotui.uic.diagnostics.internal.model;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.data.status.Diagnostics;

/**
 * What a part said at a moment.
 *
 * @param nanos when it was received, monotonic
 * @param level how it was
 * @param hardware the device, may be empty
 * @param message a sentence
 * @param keys names of the details, in the order given
 * @param values the details
 * @param bytes about how much memory it takes beyond what it shares with the moment before
 */
record Moment(long nanos, Level level, String hardware, String message, List<String> keys, List<String> values,
    int bytes) {
  private static final int MOST_VALUES = 1000;
  private static final int LONGEST = 8192;
  private static final int OBJECTS = 160;
  private static final int PER_VALUE = 8;
  private static final int PER_TEXT = 48;

  /** Takes over what a part says; texts that did not change are shared with the moment before. */
  static Moment of(Diagnostics.Item item, long nanos, Optional<Moment> before) {
    int[] bytes = {OBJECTS};
    String message = shared(item.message(), before.map(Moment::message), bytes);
    String hardware = shared(item.hardware(), before.map(Moment::hardware), bytes);
    List<String> keys = texts(item.values().keySet(), before.map(Moment::keys).orElse(List.of()), bytes);
    List<String> values = texts(item.values().values(), before.map(Moment::values).orElse(List.of()), bytes);
    return new Moment(nanos, Level.of(item.level()), hardware, message, keys, values, bytes[0]);
  }

  /** Whether it says something else than another. */
  boolean differs(Moment other) {
    return level != other.level || !message.equals(other.message) || !hardware.equals(other.hardware)
        || !keys.equals(other.keys)
        || !values.equals(other.values);
  }

  private static List<String> texts(Iterable<String> texts, List<String> before, int[] bytes) {
    List<String> result = new ArrayList<>();
    for (String text : texts) {
      int at = result.size();
      if (at == MOST_VALUES) {
        break;
      }
      result.add(shared(text, at < before.size() ? Optional.of(before.get(at)) : Optional.empty(), bytes));
    }
    if (result.equals(before)) {
      return before;
    }
    bytes[0] += PER_VALUE * result.size();
    return List.copyOf(result);
  }

  private static String shared(String text, Optional<String> before, int[] bytes) {
    String cut = text.length() <= LONGEST ? text : text.substring(0, LONGEST) + "\u2026";
    if (before.filter(cut::equals).isPresent()) {
      return before.get();
    }
    bytes[0] += PER_TEXT + 2 * cut.length();
    return cut;
  }

  /** The detail of a name, for tests and tooltips. */
  Map<String, String> details() {
    Map<String, String> details = new java.util.LinkedHashMap<>();
    for (int i = 0; i < Math.min(keys.size(), values.size()); i++) {
      details.put(keys.get(i), values.get(i));
    }
    return details;
  }
}
