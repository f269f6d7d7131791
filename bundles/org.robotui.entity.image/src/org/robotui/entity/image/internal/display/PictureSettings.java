package org.robotui.entity.image.internal.display;

import org.robotui.api.config.Setting;
import org.robotui.api.config.ValueType;

/** Settings that both kinds of displays have. */
final class PictureSettings {
  static final String OPACITY = "opacity";
  static final String PIXELS = "pixels";

  private PictureSettings() {}

  static Setting opacity(double fallback) {
    return Setting.of(OPACITY, new ValueType.Num(0, 1, ""), fallback, "0 invisible to 1 opaque.");
  }

  static Setting pixels() {
    return Setting.of(PIXELS, new ValueType.Int(16, 4096), 1024L,
        "The most pixels along an edge; a larger picture is shrunk, which saves memory and time.");
  }
}
