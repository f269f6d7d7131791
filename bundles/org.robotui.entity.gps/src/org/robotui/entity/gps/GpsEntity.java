package org.robotui.entity.gps;

import java.util.Optional;
import org.eclipse.swt.graphics.Color;
import org.robotui.data.sensor.GpsFix;
import org.robotui.ui.Face;
import org.robotui.ui.Figures;
import org.robotui.ui.Role;
import org.robotui.ui.scene.Bounds;
import org.robotui.ui.scene.Description;
import org.robotui.ui.scene.Entity;
import org.robotui.ui.scene.Ink;
import org.robotui.ui.scene.Painter;
import org.robotui.ui.scene.Viewport;

/**
 * A receiver: where it is, within what circle, with what quality, and the way it has gone. Without a fix it stays at
 * its last place, hollow. The way is bounded in memory whatever comes.
 */
public final class GpsEntity implements Entity {
  private static final int CAPACITY = 12_000;
  private static final double WIDTH = 2;
  private static final double WAY_OPACITY = 0.75;
  private static final double CIRCLE_OPACITY = 0.12;
  private static final double RING_OPACITY = 0.6;
  private static final double DOT = 6;
  private static final double HALO = 8;
  private static final double LARGEST_CIRCLE = 50_000;
  private static final int LABEL_GAP = 14;

  private final Track track = new Track(CAPACITY);
  private Optional<LocalPlane> plane = Optional.empty();
  private volatile Optional<Prepared> prepared = Optional.empty();
  private volatile Ink ink;
  private volatile boolean byQuality;
  private volatile Optional<String> name = Optional.empty();

  private record Prepared(double[] way, byte[] qualities, LocalPlane.Point at, GpsFix fix, GeoPoint place,
      Bounds reach) {
    Prepared(double[] way, byte[] qualities, LocalPlane.Point at, GpsFix fix, GeoPoint place) {
      this(way, qualities, at, fix, place, reach(way, at));
    }

    private static Bounds reach(double[] way, LocalPlane.Point at) {
      double west = at.east() - 1;
      double east = at.east() + 1;
      double south = at.north() - 1;
      double north = at.north() + 1;
      for (int i = 0; i < way.length; i += 2) {
        west = Math.min(west, way[i]);
        east = Math.max(east, way[i]);
        south = Math.min(south, way[i + 1]);
        north = Math.max(north, way[i + 1]);
      }
      return new Bounds(west, south, east, north);
    }
  }

  /**
   * A receiver of which nothing is known yet.
   *
   * @param trace which colour of the theme's traces, from 0; taken modulo their number
   */
  public GpsEntity(int trace) {
    ink = new Ink.Trace(trace);
  }

  /**
   * Takes a fix. Worker thread, one at a time.
   *
   * @param fix the newest; one without a place leaves the receiver where it was
   * @param on the plane on which it is drawn
   * @param nowNanos when it was received, {@link System#nanoTime()}
   * @param keepNanos how long the way is kept
   */
  public void prepare(GpsFix fix, LocalPlane on, long nowNanos, long keepNanos) {
    if (!plane.equals(Optional.of(on))) {
      plane = Optional.of(on);
      track.replace(on);
    }
    Optional<GeoPoint> place = GeoPoint.of(fix);
    place.flatMap(on::point).ifPresent(p -> track.add(place.get(), p, fix.quality(), nowNanos));
    track.forgetBefore(nowNanos - keepNanos);
    Optional<GeoPoint> last = place.or(() -> prepared.map(Prepared::place));
    prepared = last.flatMap(l -> on.point(l).map(p -> new Prepared(track.points(), track.qualities(), p, fix, l)));
  }

  /** Forgets the way, not the place. Worker thread. */
  public void clear() {
    track.clear();
    prepared = prepared.map(p -> new Prepared(new double[0], new byte[0], p.at(), p.fix(), p.place()));
  }

  /**
   * The colour of the receiver. Any thread.
   *
   * @param chosen a trace of the theme at the beginning
   */
  public void ink(Ink chosen) {
    ink = chosen;
  }

  /**
   * How the way is coloured. Any thread.
   *
   * @param quality true for the colours of the quality, false for one colour of this receiver
   */
  public void colorByQuality(boolean quality) {
    byQuality = quality;
  }

  /**
   * Whether a name stands beside it. Any thread.
   *
   * @param shown the name, or none
   */
  public void label(Optional<String> shown) {
    name = shown;
  }

  @Override
  public void paint(Painter painter) {
    prepared.ifPresent(p -> {
      circle(painter, p);
      way(painter, p);
      place(painter, p);
    });
  }

  @Override
  public Optional<Bounds> bounds() {
    return prepared.map(Prepared::reach);
  }

  @Override
  public Optional<Description> describeAt(double x, double y, double tolerance) {
    return prepared
        .map(p -> new Description(words(p), Math.hypot(x - p.at.east(), y - p.at.north())))
        .filter(d -> d.distance() <= tolerance);
  }

  private void circle(Painter painter, Prepared p) {
    double radius = p.fix.horizontalAccuracy() * painter.viewport().scale();
    if (p.fix.quality() != GpsFix.Quality.NO_FIX && radius > DOT && radius < LARGEST_CIRCLE) {
      painter.opacity(CIRCLE_OPACITY).fill(FixLook.role(p.fix.quality())).disc(p.at.east(), p.at.north(), radius);
      painter.opacity(RING_OPACITY).stroke(FixLook.role(p.fix.quality())).width(1).circle(p.at.east(), p.at.north(),
          radius);
      painter.opacity(1);
    }
  }

  /** In runs of one colour; steps that cannot be told apart on the screen are left out. */
  private void way(Painter painter, Prepared p) {
    painter.opacity(WAY_OPACITY).width(WIDTH);
    int from = 0;
    for (int i = 1; i <= p.qualities.length; i++) {
      if (i == p.qualities.length || byQuality && p.qualities[i] != p.qualities[from]) {
        painter.stroke(wayColor(painter, p.qualities[from]));
        WayLine.paint(painter, p.way, from, Math.min(i, p.qualities.length - 1));
        from = i;
      }
    }
    painter.opacity(1);
  }

  private Color wayColor(Painter painter, byte quality) {
    return byQuality ? painter.theme().color(FixLook.role(GpsFix.Quality.values()[quality])) : traceColor(painter);
  }

  private Color traceColor(Painter painter) {
    return ink.of(painter.theme(), Role.ACCENT);
  }

  private void place(Painter painter, Prepared p) {
    Role role = FixLook.role(p.fix.quality());
    double x = p.at.east();
    double y = p.at.north();
    painter.fill(Role.PANEL).disc(x, y, HALO);
    painter.stroke(traceColor(painter)).width(WIDTH).circle(x, y, HALO);
    if (p.fix.quality() == GpsFix.Quality.NO_FIX) {
      Viewport v = painter.viewport();
      double arm = DOT / 2 / v.scale();
      painter.stroke(role).width(WIDTH).line(x - arm, y - arm, x + arm, y + arm);
      painter.line(x - arm, y + arm, x + arm, y - arm);
    } else {
      painter.fill(role).disc(x, y, DOT - 1);
    }
    name.ifPresent(n -> {
      painter.stroke(Role.TEXT);
      painter.label(n, x, y, LABEL_GAP, 0, Face.SMALL);
    });
  }

  private static String words(Prepared p) {
    String accuracy = Double.isFinite(p.fix.horizontalAccuracy())
        ? "  \u00b1" + Figures.of(p.fix.horizontalAccuracy(), 2, "m")
        : "";
    return FixLook.word(p.fix.quality()) + accuracy + "\n" + GeoText.decimal(p.place);
  }
}
