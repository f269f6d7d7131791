package org.robotui.uic.plot.internal.model;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/** How samples are joined. */
public enum LineStyle {
  /** By straight lines. */
  LINE,
  /** A value holds until the next. */
  STEP,
  /** Not at all. */
  DOTS;

  public String word() {
    return name().toLowerCase(Locale.ROOT);
  }

  public static List<String> words() {
    return Arrays.stream(values()).map(LineStyle::word).toList();
  }

  public static LineStyle of(String word) {
    return valueOf(word.toUpperCase(Locale.ROOT));
  }
}
