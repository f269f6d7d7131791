package org.robotui.uic.map.internal.view;

import org.robotui.api.config.Settings;
import org.robotui.api.config.SettingsStore;
import org.eclipse.swt.widgets.Display;
import org.robotui.ui.UiContext;
import org.robotui.ui.scene.KeptViewport;
import org.robotui.uic.map.internal.MapOptions;

/** What the user has chosen, kept in the settings. Safe for all threads. */
public final class MapChoices {
  private final SettingsStore settings;
  private volatile Read last;

  /** Settings and what was read of them: every paint asks several times. */
  private record Read(Settings settings, MapOptions options) {
    static Read of(Settings settings) {
      return new Read(settings, MapOptions.of(settings));
    }
  }

  public MapChoices(SettingsStore settings) {
    this.settings = settings;
    this.last = Read.of(settings.current());
  }

  public MapOptions options() {
    Settings now = settings.current();
    Read known = last;
    if (known.settings() != now) {
      known = Read.of(now);
      last = known;
    }
    return known.options();
  }

  void follow(boolean on) {
    settings.set(MapOptions.FOLLOW, on);
  }

  void list(boolean open) {
    settings.set(MapOptions.LIST, open);
  }

  void fixedFrame(String name) {
    settings.set(MapOptions.FIXED_FRAME, name);
  }

  KeptViewport camera(UiContext context, Display display) {
    return KeptViewport.in(settings, context, display);
  }
}
