package org.robotui.entity.odometry.internal.layer;

import java.util.Optional;
import org.robotui.data.navigation.Odometry;
import org.robotui.entity.odometry.OdometryEntity;
import org.robotui.entity.odometry.internal.colored.ColorBy;
import org.robotui.entity.odometry.internal.colored.ColoredTrail;
import org.robotui.geometry.RigidTransform;
import org.robotui.ui.ColorBar;
import org.robotui.ui.layer.DataLayer;
import org.robotui.ui.layer.LayerContext;
import org.robotui.ui.layer.LayerResult;
import org.robotui.ui.layer.LayerStatus;
import org.robotui.ui.layer.LayerTick;
import org.robotui.ui.layer.NewestLayer;
import org.robotui.ui.scene.Bounds;
import org.robotui.ui.scene.Description;
import org.robotui.ui.scene.Ink;
import org.robotui.ui.scene.Painter;
import org.robotui.ui.scene.Placer;

/** The trail of a robot, in one colour, or coloured by a value. */
final class TrailLayer implements DataLayer {
  private static final LayerStatus NOTHING = new LayerStatus.NoData("no data yet that can be shown");

  private final OdometryEntity plain = new OdometryEntity(0);
  private final NewestLayer<Odometry> newest;
  private final ColoredTrail trail;
  private final ColoredWayEntity colored = new ColoredWayEntity();
  private Optional<Shown> shown = Optional.empty();
  private volatile boolean byValue;

  /** What the coloured way was prepared of. */
  private record Shown(ColoredTrail.Seen seen, RigidTransform fixedFromFrame) {}

  TrailLayer(LayerContext context) {
    trail = new ColoredTrail(Odometry.class, context.background(), context::history);
    newest = new NewestLayer<>(Odometry.class, NewestLayer.When.NOW, Odometry::frame, plain, this::prepare,
        (odometry, tick) -> "", plain::clear);
  }

  private LayerStatus prepare(Odometry odometry, RigidTransform place, LayerTick tick) {
    plain.ink(tick.ink() instanceof Ink.Usual ? new Ink.Trace(tick.entry().number()) : tick.ink());
    plain.showUncertainty(tick.settings().flag("uncertainty"));
    plain.prepare(odometry, place, tick.settings().number("length"));
    return new LayerStatus.Shown("");
  }

  @Override
  public LayerResult update(LayerTick tick) {
    ColorBy by = ColorBy.of(tick.settings());
    boolean switched = byValue != by.field().isPresent();
    byValue = by.field().isPresent();
    if (!byValue) {
      colored.clear();
      shown = Optional.empty();
      LayerResult result = newest.update(tick);
      return new LayerResult(switched || result.changed(), result.status());
    }
    LayerResult result = color(tick, by);
    return new LayerResult(switched || result.changed(), result.status());
  }

  private LayerResult color(LayerTick tick, ColorBy by) {
    Optional<ColoredTrail.Seen> seen =
        trail.update(tick.arrived(), by, tick.settings().number("length"), tick.reset());
    if (tick.placer().isEmpty() || seen.isEmpty()) {
      return new LayerResult(tick.reset(), tick.placer().isEmpty() ? new LayerStatus.NoFrame("no frame is known")
          : NOTHING);
    }
    Placer.Placement place = tick.placer().get().latest(seen.get().way().frame());
    if (place instanceof Placer.Placement.Missing missing) {
      return new LayerResult(false, new LayerStatus.NoFrame(missing.reason()));
    }
    Shown next = new Shown(seen.get(), place.found().orElseThrow());
    boolean changed = !shown.equals(Optional.of(next));
    if (changed) {
      shown = Optional.of(next);
      colored.prepare(next.seen, next.fixedFromFrame);
    }
    return new LayerResult(changed, next.seen.problem().<LayerStatus>map(LayerStatus.Partly::new)
        .orElseGet(() -> new LayerStatus.Shown("")));
  }

  @Override
  public Optional<ColorBar> colors() {
    return byValue ? colored.colors() : Optional.empty();
  }

  @Override
  public void paint(Painter painter) {
    if (byValue) {
      colored.paint(painter);
    } else {
      newest.paint(painter);
    }
  }

  @Override
  public Optional<Bounds> bounds() {
    return byValue ? colored.bounds() : newest.bounds();
  }

  @Override
  public Optional<Description> describeAt(double x, double y, double tolerance) {
    return byValue ? colored.describeAt(x, y, tolerance) : newest.describeAt(x, y, tolerance);
  }
}
