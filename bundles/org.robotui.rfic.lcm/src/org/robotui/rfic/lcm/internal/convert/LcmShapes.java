package org.robotui.rfic.lcm.internal.convert;

import java.util.Collections;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Stream;

/** All data types that messages may become, by the word after {@code as:}. */
public final class LcmShapes {
  private static final Map<String, Shape<?>> ALL = all();

  private LcmShapes() {}

  private static Map<String, Shape<?>> all() {
    Map<String, Shape<?>> all = new TreeMap<>();
    Stream.of(MotionShapes.all(), SensorShapes.all(), PictureShapes.all(), StateShapes.all())
        .forEach(group -> group.forEach(s -> all.put(s.form().word(), s)));
    return Collections.unmodifiableMap(all);
  }

  /**
   * Finds one.
   *
   * @param word after {@code as:}
   * @return the data type
   */
  public static Optional<Shape<?>> of(String word) {
    return Optional.ofNullable(ALL.get(word));
  }

  /** All words, for messages. */
  public static String words() {
    return String.join(", ", ALL.keySet());
  }
}
