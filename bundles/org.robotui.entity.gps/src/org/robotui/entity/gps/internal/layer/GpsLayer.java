package org.robotui.entity.gps.internal.layer;

import java.util.Optional;
import org.robotui.api.port.Envelope;
import org.robotui.data.sensor.GpsFix;
import org.robotui.entity.gps.GeoPoint;
import org.robotui.entity.gps.GpsEntity;
import org.robotui.entity.gps.LocalPlane;
import org.robotui.ui.layer.DataLayer;
import org.robotui.ui.layer.EarthOrigin;
import org.robotui.ui.layer.LayerEntry;
import org.robotui.ui.layer.LayerResult;
import org.robotui.ui.layer.LayerStatus;
import org.robotui.ui.layer.LayerTick;
import org.robotui.ui.scene.Bounds;
import org.robotui.ui.scene.Description;
import org.robotui.ui.scene.Ink;
import org.robotui.ui.scene.Painter;

/** One receiver and its track. */
final class GpsLayer implements DataLayer {
  private static final double NANOS_PER_MINUTE = 60e9;

  private final GpsEntity entity = new GpsEntity(0);
  private Optional<Envelope<GpsFix>> newest = Optional.empty();
  private Optional<Basis> basis = Optional.empty();

  /** What the track was drawn for, beside the fix. */
  private record Basis(Optional<EarthOrigin> origin, LayerEntry entry) {}

  @Override
  public LayerResult update(LayerTick tick) {
    if (tick.reset()) {
      entity.clear();
    }
    Optional<Envelope<GpsFix>> came = tick.newest(GpsFix.class);
    newest = came.or(() -> newest);
    Optional<Basis> next = Optional.of(new Basis(tick.origin(), tick.entry()));
    boolean due = came.isPresent() || !next.equals(basis) || tick.reset();
    basis = next;
    if (due && newest.isPresent()) {
      look(tick.entry());
      tick.origin().ifPresent(origin -> prepare(newest.get(), origin, tick.entry()));
    }
    return new LayerResult(due && newest.isPresent(), status(tick));
  }

  private void look(LayerEntry entry) {
    String colors = entry.settings().text("way_colors");
    entity.colorByQuality(colors.equals("quality") || colors.equals("auto") && entry.count() < 2);
    entity.label(entry.count() > 1 ? Optional.of(entry.name()) : Optional.empty());
    entity.ink(entry.ink() instanceof Ink.Usual ? new Ink.Trace(entry.number()) : entry.ink());
  }

  private void prepare(Envelope<GpsFix> fix, EarthOrigin origin, LayerEntry entry) {
    LocalPlane plane = new LocalPlane(new GeoPoint(origin.latitude(), origin.longitude()));
    entity.prepare(fix.value(), plane, fix.receivedNanos(),
        (long) (entry.settings().number("trail_minutes") * NANOS_PER_MINUTE));
  }

  private LayerStatus status(LayerTick tick) {
    if (newest.isEmpty()) {
      return new LayerStatus.NoData("no fix yet");
    }
    if (tick.origin().isEmpty()) {
      return new LayerStatus.NoData("no receiver knows where it is");
    }
    return entity.bounds().isPresent() ? new LayerStatus.Shown("") : new LayerStatus.Partly("no place on the plane");
  }

  @Override
  public void paint(Painter painter) {
    entity.paint(painter);
  }

  @Override
  public Optional<Bounds> bounds() {
    return entity.bounds();
  }

  @Override
  public Optional<Description> describeAt(double x, double y, double tolerance) {
    return entity.describeAt(x, y, tolerance);
  }
}
