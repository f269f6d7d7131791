package org.robotui.uic.gps.internal.view;

import java.util.Optional;
import org.robotui.entity.gps.GeoPoint;
import org.robotui.entity.gps.GeoText;
import org.robotui.entity.gps.Geodesic;
import org.robotui.entity.gps.LocalPlane;
import org.robotui.ui.Face;
import org.robotui.ui.Role;
import org.robotui.ui.scene.Painter;

/**
 * Measures between two clicks: the shortest way on the earth and its bearing. The ends are places, so the measure stays
 * right when the plane changes. Display thread.
 */
final class Ruler {
  private static final double LABEL_GAP = 12;
  private static final double DOT = 3;
  private static final double DASH = 5;

  private Optional<GeoPoint> from = Optional.empty();
  private Optional<GeoPoint> to = Optional.empty();
  private boolean held;

  /** Sets the first end, then the second, then begins anew. */
  void click(GeoPoint place) {
    if (held) {
      to = Optional.of(place);
      held = false;
    } else {
      from = Optional.of(place);
      to = Optional.empty();
      held = true;
    }
  }

  /** The second end goes with the pointer until it is set. */
  void move(GeoPoint place) {
    if (held) {
      to = Optional.of(place);
    }
  }

  String hint() {
    return held ? "Measure: click the other end \u00b7 Esc ends"
        : "Measure: click one end, then the other \u00b7 Esc ends";
  }

  /** What was measured. */
  Optional<Geodesic> measure() {
    return from.flatMap(f -> to.map(t -> Geodesic.between(f, t)));
  }

  void paint(Painter painter, LocalPlane plane) {
    Optional<LocalPlane.Point> a = from.flatMap(plane::point);
    Optional<LocalPlane.Point> b = to.flatMap(plane::point);
    painter.opacity(1).stroke(Role.TEXT).fill(Role.TEXT);
    a.ifPresent(p -> painter.disc(p.east(), p.north(), DOT));
    if (a.isPresent() && b.isPresent()) {
      LocalPlane.Point end = b.get();
      painter.dashed(1.5, DASH).line(a.get().east(), a.get().north(), end.east(), end.north());
      painter.width(1.5).disc(end.east(), end.north(), DOT);
      measure().ifPresent(m -> painter.label(
          GeoText.distance(m.distance()) + "  " + GeoText.bearing(m.bearing()), end.east(), end.north(), LABEL_GAP,
          -LABEL_GAP, Face.FIGURES));
    }
  }
}
