package org.robotui.entity.grid.internal.display;

import java.util.Optional;
import org.robotui.data.FrameId;
import org.robotui.gl.display.Places;

/** Finds the frame that a setting names. */
final class FrameChoice {
  private FrameChoice() {}

  /**
   * Where the frame is: nothing written is the fixed frame; {@code robot/frame}, {@code robot:frame} or the frame
   * alone.
   */
  static Places.Place place(Places places, String written) {
    Optional<FrameId> known = written.isBlank() ? Optional.of(places.fixed()) : find(places, written);
    return known.map(frame -> places.at(frame, Optional.empty()))
        .orElseGet(() -> new Places.Place.Missing("no frame " + written + " is known yet"));
  }

  private static Optional<FrameId> find(Places places, String written) {
    String name = written.startsWith("/") ? written.substring(1) : written;
    return places.all().stream()
        .filter(
            f -> f.toString().equals(written) || written.equals(f.robot() + '/' + f.name()) || f.name().equals(name))
        .findFirst();
  }
}
