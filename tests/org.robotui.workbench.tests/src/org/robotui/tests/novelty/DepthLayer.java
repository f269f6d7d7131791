package org.robotui.tests.novelty;

import java.util.Optional;
import org.eclipse.swt.graphics.Color;
import org.robotui.api.port.Envelope;
import org.robotui.geometry.Vector3;
import org.robotui.ui.layer.DataLayer;
import org.robotui.ui.layer.EarthOrigin;
import org.robotui.ui.layer.LayerResult;
import org.robotui.ui.layer.LayerStatus;
import org.robotui.ui.layer.LayerTick;
import org.robotui.ui.scene.Bounds;
import org.robotui.ui.scene.Description;
import org.robotui.ui.scene.Painter;

/** A disc where the newest depth was measured. */
final class DepthLayer implements DataLayer {
  private static final double PIXELS = 40;
  private static final double EARTH_RADIUS = 6_371_000;

  private Optional<WaterDepth> newest = Optional.empty();
  private volatile Optional<Vector3> place = Optional.empty();

  @Override
  public LayerResult update(LayerTick tick) {
    newest = tick.newest(WaterDepth.class).map(Envelope::value).or(() -> newest);
    Optional<Vector3> next = newest.flatMap(depth -> place(depth, tick));
    boolean changed = !next.equals(place);
    place = next;
    return new LayerResult(changed,
        next.isPresent() ? new LayerStatus.Shown("") : new LayerStatus.NoData("no depth yet"));
  }

  private static Optional<Vector3> place(WaterDepth depth, LayerTick tick) {
    return tick.origin().map(origin -> onEarth(depth, origin)).or(() -> tick.placer()
        .flatMap(placer -> placer.latest(depth.frame()).found()).map(fixedFromFrame -> fixedFromFrame.translation()));
  }

  private static Vector3 onEarth(WaterDepth depth, EarthOrigin origin) {
    double east = (depth.longitude() - origin.longitude()) * Math.cos(origin.latitude()) * EARTH_RADIUS;
    return new Vector3(east, (depth.latitude() - origin.latitude()) * EARTH_RADIUS, 0);
  }

  @Override
  public void paint(Painter painter) {
    place.ifPresent(at -> painter.fill(new Color(DepthDisplayType.RGB >> 16, 0, DepthDisplayType.RGB & 0xff))
        .disc(at.x(), at.y(), PIXELS));
  }

  @Override
  public Optional<Bounds> bounds() {
    return place.map(at -> Bounds.around(at.x(), at.y(), 1));
  }

  @Override
  public Optional<Description> describeAt(double x, double y, double tolerance) {
    return Optional.empty();
  }

  @Override
  public void dispose() {
    // It holds nothing of the display.
  }
}
