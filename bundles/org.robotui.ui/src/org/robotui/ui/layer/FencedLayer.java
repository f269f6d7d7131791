package org.robotui.ui.layer;

import java.util.Optional;
import java.util.function.Supplier;
import org.robotui.ui.ColorBar;
import org.robotui.ui.scene.Bounds;
import org.robotui.ui.scene.Description;
import org.robotui.ui.scene.Entity;
import org.robotui.ui.scene.Painter;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A layer of whatever bundle: one that throws is done with, and neither the view nor the display thread fails of it.
 */
final class FencedLayer implements Entity {
  private static final Logger LOG = LoggerFactory.getLogger(FencedLayer.class);

  private final String id;
  private volatile Optional<DataLayer> layer = Optional.empty();
  private volatile Optional<String> fault = Optional.empty();

  private FencedLayer(String id) {
    this.id = id;
  }

  static FencedLayer of(LayerType type, LayerContext context) {
    FencedLayer made = new FencedLayer(type.id());
    made.layer = made.guarded(() -> Optional.of(type.create(context)), Optional.empty());
    return made;
  }

  /** Why it failed. */
  Optional<String> fault() {
    return fault;
  }

  LayerResult update(LayerTick tick) {
    LayerResult failed = new LayerResult(true, new LayerStatus.NoData(""));
    return layer.map(l -> guarded(() -> l.update(tick), failed)).orElse(failed);
  }

  Optional<ColorBar> colors() {
    return alive().flatMap(l -> guarded(l::colors, Optional.empty()));
  }

  @Override
  public void paint(Painter painter) {
    alive().ifPresent(l -> guarded(() -> {
      l.paint(painter);
      return true;
    }, false));
  }

  @Override
  public Optional<Bounds> bounds() {
    return alive().flatMap(l -> guarded(l::bounds, Optional.empty()));
  }

  @Override
  public Optional<Description> describeAt(double x, double y, double tolerance) {
    return alive().flatMap(l -> guarded(() -> l.describeAt(x, y, tolerance), Optional.empty()));
  }

  @Override
  public void dispose() {
    layer.ifPresent(l -> guarded(() -> {
      l.dispose();
      return true;
    }, false));
  }

  private Optional<DataLayer> alive() {
    return fault.isPresent() ? Optional.empty() : layer;
  }

  private <R> R guarded(Supplier<R> task, R otherwise) {
    try {
      return task.get();
    } catch (RuntimeException | LinkageError e) {
      LOG.warn("A layer of kind {} failed and is switched off", id, e);
      fault = Optional.of(Optional.ofNullable(e.getMessage()).orElse(e.getClass().getSimpleName()));
      return otherwise;
    }
  }
}
