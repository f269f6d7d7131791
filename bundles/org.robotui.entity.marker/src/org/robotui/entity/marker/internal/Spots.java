package org.robotui.entity.marker.internal;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.data.marker.Marker;
import org.robotui.geometry.RigidTransform;
import org.robotui.gl.display.Places;
import org.robotui.gl.display.Places.Place;

/** Where frames are during one tick; each is asked for once. */
final class Spots {
  private record When(FrameId frame, Optional<Stamp> stamp) {}

  private final Places places;
  private final Map<When, Place> asked = new HashMap<>();
  private Optional<String> missing = Optional.empty();

  Spots(Places places) {
    this.places = places;
  }

  /** Why something is not seen, if there is a frame that nobody tells of. */
  Optional<String> missing() {
    return missing;
  }

  /** Where a new marker is to be drawn: with its frame, or where the frame was when it was made, or else now. */
  Optional<Spot> of(Marker marker) {
    if (marker.locked()) {
      return Optional.of(new Spot.With(marker.frame()));
    }
    Optional<RigidTransform> then = marker.stamp().flatMap(stamp -> ask(marker.frame(), Optional.of(stamp)).found());
    return then.or(() -> now(marker.frame())).map(Spot.Still::new);
  }

  /** Where a spot is now. */
  Optional<RigidTransform> at(Spot spot) {
    return switch (spot) {
      case Spot.Still still -> Optional.of(still.fixedFromFrame());
      case Spot.With with -> now(with.frame());
    };
  }

  private Optional<RigidTransform> now(FrameId frame) {
    Place place = ask(frame, Optional.empty());
    if (place instanceof Place.Missing lost) {
      missing = missing.or(() -> Optional.of(lost.reason()));
    }
    return place.found();
  }

  private Place ask(FrameId frame, Optional<Stamp> stamp) {
    return asked.computeIfAbsent(new When(frame, stamp), when -> places.at(frame, stamp));
  }
}
