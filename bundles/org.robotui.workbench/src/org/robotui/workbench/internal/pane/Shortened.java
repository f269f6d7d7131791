package org.robotui.workbench.internal.pane;

import org.eclipse.swt.graphics.GC;

/** Text that fits. */
final class Shortened {
  private static final String MORE = "\u2026";

  private Shortened() {}

  /** The text, or its beginning and an ellipsis where it is wider than a width in pixels. */
  static String to(GC gc, String text, int width) {
    if (gc.textExtent(text).x <= width) {
      return text;
    }
    int low = 0;
    int high = text.length();
    while (low < high) {
      int middle = (low + high + 1) / 2;
      if (gc.textExtent(text.substring(0, middle) + MORE).x <= width) {
        low = middle;
      } else {
        high = middle - 1;
      }
    }
    return low == 0 ? "" : text.substring(0, low).stripTrailing() + MORE;
  }

  /** The text, or its beginning and its end, by which names of the same root differ. */
  static String inTheMiddle(GC gc, String text, int width) {
    String fitting = text;
    for (int length = text.length() - 1; length > 0 && gc.textExtent(fitting).x > width; length--) {
      int end = (length + 1) / 2;
      fitting = text.substring(0, length - end) + MORE + text.substring(text.length() - end);
    }
    return gc.textExtent(fitting).x <= width ? fitting : "";
  }
}
