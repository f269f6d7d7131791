package org.robotui.bridge.internal.change;

import java.time.Duration;
import java.util.Optional;
import org.robotui.api.bridge.BridgeWords;
import org.robotui.api.config.Settings;
import org.robotui.api.port.Envelope;
import org.robotui.api.time.RobotClock;
import org.robotui.data.Stamp;

/**
 * Moves stamps of one robot to the clock of another one.
 *
 * @param way one of the words of {@link BridgeWords}
 * @param givenNanos what is added besides
 * @param from the clock of the robot that says the value
 * @param to that of the robot that hears it
 */
public record StampMoving(String way, long givenNanos, RobotClock from, RobotClock to) {
  private static final double NANOS = 1e9;

  /** As configured. */
  public static StampMoving of(Settings settings, boolean back, RobotClock from, RobotClock to) {
    long given = Math.round(settings.number("stamp_offset") * NANOS);
    return new StampMoving(settings.text("stamps"), back ? -given : given, from, to);
  }

  /** Whether all stamps stay what they are. */
  public boolean isNone() {
    return way.equals(BridgeWords.KEEP_STAMPS) && givenNanos == 0;
  }

  /** The stamp of a value for the other robot; a value without one is as old as its reception. */
  public Optional<Stamp> of(Envelope<?> envelope) {
    boolean made = way.equals(BridgeWords.NEW_STAMPS) || envelope.stamp().isEmpty();
    return Optional.of(made ? received(envelope)
        : new Stamp(envelope.stamp().get().nanos() + shiftNanos(), to.kind()));
  }

  private Stamp received(Envelope<?> envelope) {
    Stamp now = to.now();
    return new Stamp(now.nanos() - (System.nanoTime() - envelope.receivedNanos()) + givenNanos, now.clock());
  }

  /** What is added to a stamp that stands within a value. */
  long shiftNanos() {
    return givenNanos + (way.equals(BridgeWords.MOVE_STAMPS) ? nanos(to) - nanos(from) : 0);
  }

  private static long nanos(RobotClock clock) {
    return clock.offset().map(Duration::toNanos).orElse(0L);
  }
}
