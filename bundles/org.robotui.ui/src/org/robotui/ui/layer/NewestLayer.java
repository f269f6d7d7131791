package org.robotui.ui.layer;

import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Function;
import org.robotui.api.port.Envelope;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.geometry.RigidTransform;
import org.robotui.ui.scene.Bounds;
import org.robotui.ui.scene.Description;
import org.robotui.ui.scene.Entity;
import org.robotui.ui.scene.Painter;
import org.robotui.ui.scene.Placer;

/**
 * A layer of the newest value of its sources: an entity that is prepared anew where another value came, where the value
 * lies elsewhere, where the settings changed, or whatever else it depends on. Most layers are one of these.
 *
 * @param <T> the type of the value
 */
public final class NewestLayer<T extends Data> implements DataLayer {
  /** Which transform places a value. */
  public enum When {
    /** That of the time of measurement: a scan stays where it was made. */
    MEASURED,
    /** The newest: a map or a path moves with its frame. */
    NOW
  }

  /**
   * Prepares the entity. Worker thread.
   *
   * @param <T> the type of the value
   */
  @FunctionalInterface
  public interface Preparer<T extends Data> {
    /**
     * Takes a value in place of the one before.
     *
     * @param value the newest
     * @param fixedFromFrame fixed frame from the frame of the value
     * @param tick settings, colour, robots
     * @return how it is
     */
    LayerStatus prepare(T value, RigidTransform fixedFromFrame, LayerTick tick);
  }

  /** What an entity was prepared for, beside its value. */
  private record Basis(FrameId fixed, Object place, LayerEntry entry, Object dependence) {}

  private final Class<T> type;
  private final When when;
  private final Function<T, FrameId> frame;
  private final Entity entity;
  private final Preparer<T> preparer;
  private final BiFunction<T, LayerTick, Object> dependence;
  private final Runnable forget;
  private Optional<Envelope<T>> newest = Optional.empty();
  private Optional<T> shown = Optional.empty();
  private Optional<Basis> basis = Optional.empty();
  private LayerStatus status = new LayerStatus.NoData("no data yet that can be shown");

  /**
   * A layer that depends on nothing else and keeps nothing of earlier values.
   *
   * @param type of the values
   * @param when which transform places them
   * @param frame the frame of a value
   * @param entity what is painted
   * @param preparer prepares it
   */
  public NewestLayer(Class<T> type, When when, Function<T, FrameId> frame, Entity entity, Preparer<T> preparer) {
    this(type, when, frame, entity, preparer, (value, tick) -> "", () -> {});
  }

  /**
   * A layer.
   *
   * @param type of the values
   * @param when which transform places them
   * @param frame the frame of a value
   * @param entity what is painted
   * @param preparer prepares it
   * @param dependence what else it depends on, with equals
   * @param forget forgets what was collected of earlier values, as the clock of the robot jumped back
   */
  public NewestLayer(Class<T> type, When when, Function<T, FrameId> frame, Entity entity, Preparer<T> preparer,
      BiFunction<T, LayerTick, Object> dependence, Runnable forget) {
    this.type = type;
    this.when = when;
    this.frame = frame;
    this.entity = entity;
    this.preparer = preparer;
    this.dependence = dependence;
    this.forget = forget;
  }

  @Override
  public LayerResult update(LayerTick tick) {
    if (tick.reset()) {
      forget.run();
    }
    newest = tick.newest(type).or(() -> newest);
    boolean prepared = newest.isPresent() && prepare(newest.get(), tick);
    return new LayerResult(prepared || tick.reset(), status);
  }

  private boolean prepare(Envelope<T> envelope, LayerTick tick) {
    if (tick.placer().isEmpty()) {
      status = new LayerStatus.NoFrame("no frame is known");
      return false;
    }
    T value = envelope.value();
    Placer placer = tick.placer().get();
    Object place = when == When.NOW ? placer.latest(frame.apply(value)) : "";
    Basis next = new Basis(placer.fixed(), place, tick.entry(), dependence.apply(value, tick));
    if (shown.filter(s -> s == value).isPresent() && basis.filter(next::equals).isPresent()) {
      return false;
    }
    Placer.Placement placement = placement(placer, envelope);
    if (placement instanceof Placer.Placement.Missing missing) {
      status = new LayerStatus.NoFrame(missing.reason());
      return false;
    }
    status = preparer.prepare(value, placement.found().orElseThrow(), tick);
    shown = Optional.of(value);
    basis = Optional.of(next);
    return true;
  }

  private Placer.Placement placement(Placer placer, Envelope<T> envelope) {
    FrameId of = frame.apply(envelope.value());
    return when == When.NOW ? placer.latest(of) : placer.at(of, envelope.stamp());
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

  @Override
  public void dispose() {
    entity.dispose();
  }
}
