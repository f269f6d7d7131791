package org.robotui.uic.camera.internal;

import java.util.Optional;
import org.robotui.api.config.SettingsStore;
import org.robotui.entity.image.ColorMap;
import org.robotui.entity.image.Span;

/** What the user has chosen, kept in the settings. Safe for all threads. */
final class CameraChoices {
  private final SettingsStore settings;

  CameraChoices(SettingsStore settings) {
    this.settings = settings;
  }

  CameraOptions options() {
    return CameraOptions.of(settings.current());
  }

  void zoom(ZoomMode mode) {
    settings.set(CameraOptions.ZOOM, mode.id());
  }

  void map(Optional<ColorMap> map) {
    settings.set(CameraOptions.COLOR_MAP, map.map(ColorMap::id).orElse(CameraOptions.AUTO));
  }

  /** The next colours after those that are seen. */
  void nextMap(ColorMap now) {
    ColorMap[] all = ColorMap.values();
    map(Optional.of(all[(now.ordinal() + 1) % all.length]));
  }

  /** A range, or none to follow the pictures. */
  void range(Optional<Span> range) {
    range.ifPresent(r -> {
      settings.set(CameraOptions.RANGE_MIN, r.low());
      settings.set(CameraOptions.RANGE_MAX, r.high());
    });
    settings.set(CameraOptions.RANGE, range.isPresent() ? CameraOptions.FIXED : CameraOptions.AUTO);
  }

  void set(String flag, boolean on) {
    settings.set(flag, on);
  }

  void toggle(String flag) {
    settings.set(flag, !settings.current().flag(flag));
  }
}
