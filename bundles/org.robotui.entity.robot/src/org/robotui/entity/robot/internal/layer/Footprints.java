package org.robotui.entity.robot.internal.layer;

import java.util.List;
import java.util.Optional;
import org.robotui.api.port.Envelope;
import org.robotui.data.geometry.Footprint;
import org.robotui.geometry.Vector3;
import org.robotui.ui.scene.Placer;

/** The outlines of robots, where they lie. */
final class Footprints {
  /** Outlines of more robots are not kept. */
  static final int MOST = 1000;

  private Footprints() {}

  /**
   * The corners in the fixed frame, at the time of the outline or else now; none where it is not known where they lie.
   */
  static Optional<List<Vector3>> place(Placer placer, Envelope<Footprint> outline) {
    Footprint footprint = outline.value();
    return placer.at(footprint.frame(), outline.stamp()).found().or(() -> placer.latest(footprint.frame()).found())
        .map(place -> footprint.corners().stream().map(place::apply).toList());
  }
}
