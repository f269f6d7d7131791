package org.robotui.gl.display;

import java.util.List;
import java.util.Optional;
import java.util.function.LongToDoubleFunction;
import org.robotui.api.config.Settings;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.InputState;
import org.robotui.data.Data;
import org.robotui.gl.shape.Rgba;

/**
 * One tick of a display.
 *
 * @param arrived what its sources sent since the last tick, in the order of arrival
 * @param state how its sources are: the best of those that it needs
 * @param places where frames are
 * @param settings its settings, checked
 * @param robotColor the colour of the robot that it belongs to, for kinds that colour by robot
 * @param nowNanos {@link System#nanoTime()}
 * @param reset true where the clock of the robot jumped back: what was collected is to be forgotten
 * @param ages seconds since something was received ({@link System#nanoTime()}), as the robot's clock counts them
 */
public record DisplayTick(
    List<Envelope<? extends Data>> arrived,
    InputState state,
    Places places,
    Settings settings,
    Rgba robotColor,
    long nowNanos,
    boolean reset,
    LongToDoubleFunction ages) {
  /**
   * Copies the list.
   *
   * @param arrived what came
   * @param state of its sources
   * @param places of frames
   * @param settings checked
   * @param robotColor of the robot
   * @param nowNanos now
   * @param reset forget what was collected
   * @param ages seconds since something was received
   */
  public DisplayTick {
    arrived = List.copyOf(arrived);
  }

  /**
   * One in which ages are those by the clock of this machine.
   *
   * @param arrived what came
   * @param state of its sources
   * @param places of frames
   * @param settings checked
   * @param robotColor of the robot
   * @param nowNanos now
   * @param reset forget what was collected
   */
  public DisplayTick(List<Envelope<? extends Data>> arrived, InputState state, Places places, Settings settings,
      Rgba robotColor, long nowNanos, boolean reset) {
    this(arrived, state, places, settings, robotColor, nowNanos, reset, received -> (nowNanos - received) * 1e-9);
  }

  /**
   * How old something is; for a recording by its own time.
   *
   * @param receivedNanos when it was received, as {@link System#nanoTime()}
   * @return seconds
   */
  public double ageSeconds(long receivedNanos) {
    return ages.applyAsDouble(receivedNanos);
  }

  /**
   * The newest value of a type that came with this tick.
   *
   * @param <T> the type
   * @param type the type
   * @return the envelope, or none
   */
  @SuppressWarnings("unchecked") // the value is of the type, and an envelope only gives it out
  public <T extends Data> Optional<Envelope<T>> newest(Class<T> type) {
    return arrived.reversed().stream().filter(e -> type.isInstance(e.value())).findFirst().map(e -> (Envelope<T>) e);
  }
}
