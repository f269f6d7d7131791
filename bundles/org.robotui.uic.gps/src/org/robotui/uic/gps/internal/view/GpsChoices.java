package org.robotui.uic.gps.internal.view;

import java.util.Optional;
import org.robotui.api.config.SettingsStore;
import org.robotui.api.port.SourceId;
import org.robotui.entity.gps.GeoPoint;
import org.eclipse.swt.widgets.Display;
import org.robotui.ui.UiContext;
import org.robotui.ui.scene.KeptViewport;
import org.robotui.uic.gps.internal.GpsOptions;

/** What the user has chosen, kept in the settings. Safe for all threads. */
public final class GpsChoices {
  private final SettingsStore settings;

  public GpsChoices(SettingsStore settings) {
    this.settings = settings;
  }

  public GpsOptions options() {
    return GpsOptions.of(settings.current());
  }

  void follow(boolean on) {
    settings.set(GpsOptions.FOLLOW, on);
  }

  void follow(SourceId receiver) {
    settings.set(GpsOptions.FOLLOWED, receiver.toString());
    follow(true);
  }

  /** An origin, or none for the first fix. */
  void origin(Optional<GeoPoint> place) {
    place.ifPresent(p -> {
      settings.set(GpsOptions.ORIGIN_LATITUDE, Math.toDegrees(p.latitude()));
      settings.set(GpsOptions.ORIGIN_LONGITUDE, Math.toDegrees(p.longitude()));
    });
    settings.set(GpsOptions.ORIGIN, place.isPresent() ? GpsOptions.FIXED : GpsOptions.FIRST_FIX);
  }

  void sexagesimal(boolean on) {
    settings.set(GpsOptions.COORDINATES, on ? GpsOptions.DMS : GpsOptions.DECIMAL);
  }

  void list(boolean open) {
    settings.set(GpsOptions.LIST, open);
  }

  KeptViewport camera(UiContext context, Display display) {
    return KeptViewport.in(settings, context, display);
  }
}
