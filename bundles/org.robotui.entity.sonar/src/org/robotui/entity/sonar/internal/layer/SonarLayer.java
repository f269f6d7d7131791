package org.robotui.entity.sonar.internal.layer;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robotui.api.port.Envelope;
import org.robotui.data.sensor.RangeReading;
import org.robotui.data.sensor.RangeReadings;
import org.robotui.entity.sonar.SonarEntity;
import org.robotui.ui.layer.DataLayer;
import org.robotui.ui.layer.LayerEntry;
import org.robotui.ui.layer.LayerResult;
import org.robotui.ui.layer.LayerStatus;
import org.robotui.ui.layer.LayerTick;
import org.robotui.ui.scene.Bounds;
import org.robotui.ui.scene.Description;
import org.robotui.ui.scene.Painter;
import org.robotui.ui.scene.Placer;

/** The newest readings, each sensor where it was then. */
final class SonarLayer implements DataLayer {
  private final SonarEntity entity = new SonarEntity();
  private Optional<Envelope<RangeReadings>> newest = Optional.empty();
  private Optional<Basis> basis = Optional.empty();
  private LayerStatus status = new LayerStatus.NoData("no readings yet");

  /** What the cones were made for, beside the readings. */
  private record Basis(Object fixed, LayerEntry entry) {}

  @Override
  public LayerResult update(LayerTick tick) {
    Optional<Envelope<RangeReadings>> came = tick.newest(RangeReadings.class);
    newest = came.or(() -> newest);
    Basis next = new Basis(tick.placer().map(Placer::fixed), tick.entry());
    boolean due = newest.isPresent()
        && (came.isPresent() || !(status instanceof LayerStatus.Shown) || basis.filter(next::equals).isEmpty());
    if (due) {
      basis = Optional.of(next);
      entity.ink(tick.ink());
      status = tick.placer().map(placer -> prepare(placer, newest.get()))
          .orElse(new LayerStatus.NoFrame("no frame is known"));
    }
    return new LayerResult(due, status);
  }

  private LayerStatus prepare(Placer placer, Envelope<RangeReadings> readings) {
    List<SonarEntity.Placed> placed = new ArrayList<>();
    Optional<String> problem = Optional.empty();
    for (RangeReading reading : readings.value().readings()) {
      Placer.Placement at = placer.at(reading.frame(), readings.stamp());
      at.found().ifPresent(place -> placed.add(new SonarEntity.Placed(reading, place)));
      problem = problem
          .or(() -> at instanceof Placer.Placement.Missing missing ? Optional.of(missing.reason()) : Optional.empty());
    }
    entity.prepare(placed);
    return problem.<LayerStatus>map(LayerStatus.NoFrame::new)
        .orElseGet(() -> new LayerStatus.Shown(placed.size() + " readings"));
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
