package org.robotui.uic.camera.internal;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/** How large a picture is when nobody has zoomed. */
enum ZoomMode {
  /** All of it is seen. */
  FIT("Fit"),
  /** It fills the view. */
  FILL("Fill"),
  /** A pixel of it is a pixel of the screen. */
  ACTUAL("1:1");

  private final String label;

  ZoomMode(String label) {
    this.label = label;
  }

  String label() {
    return label;
  }

  /** As written in settings. */
  String id() {
    return name().toLowerCase(Locale.ROOT);
  }

  static List<String> ids() {
    return Arrays.stream(values()).map(ZoomMode::id).toList();
  }

  static ZoomMode of(String id) {
    return valueOf(id.toUpperCase(Locale.ROOT));
  }
}
