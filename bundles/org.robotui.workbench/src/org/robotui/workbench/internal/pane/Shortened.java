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
}
