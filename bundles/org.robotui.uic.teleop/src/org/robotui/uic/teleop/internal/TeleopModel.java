package org.robotui.uic.teleop.internal;

import java.util.EnumMap;
import java.util.EnumSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * What the user's hands want, over time: pure, not safe for several threads. A key that repeats may come as pairs of
 * release and press; a release therefore counts only when no press follows within {@link #GRACE_NANOS}.
 *
 * <p>After {@link #letGo()} the keys that are down do nothing until they have been up: what was ended by a stop does
 * not go on because a finger still lies on a key.
 */
final class TeleopModel {
  static final long GRACE_NANOS = 30_000_000;

  private static final double HALF = 0.5;
  private static final double LONGEST_STEP_SECONDS = 0.1;
  private static final double FIRST_STEP_SECONDS = 0.05;
  private static final double SECONDS_PER_NANO = 1e-9;

  private final Set<DriveKey> down = EnumSet.noneOf(DriveKey.class);
  private final Map<DriveKey, Long> leaving = new EnumMap<>(DriveKey.class);
  private final Set<DriveKey> spent = EnumSet.noneOf(DriveKey.class);
  private Optional<Stick> drag = Optional.empty();
  private Optional<Stick> pad = Optional.empty();
  private boolean padSpent;
  private boolean half;
  private Speed speed = Speed.ZERO;
  private Optional<Long> lastStep = Optional.empty();

  void press(DriveKey key, long now) {
    settle(now);
    leaving.remove(key);
    down.add(key);
  }

  void release(DriveKey key, long now) {
    settle(now);
    if (down.contains(key)) {
      leaving.put(key, now);
    }
  }

  void drag(Stick stick) {
    drag = Optional.of(stick);
  }

  void dragEnd() {
    drag = Optional.empty();
  }

  /** The dead-man button of a gamepad is held. */
  void pad(Stick stick) {
    pad = padSpent ? Optional.empty() : Optional.of(stick);
  }

  /** The dead-man button is up, or the gamepad is gone. */
  void padEnd() {
    pad = Optional.empty();
    padSpent = false;
  }

  /** The gamepad does nothing until its dead-man button has been up. */
  void padLetGo() {
    pad = Optional.empty();
    padSpent = true;
  }

  boolean padHeld() {
    return pad.isPresent();
  }

  void half(boolean on) {
    half = on;
  }

  /**
   * Whether a hand is on the mouse, on a key or on a gamepad: the dead-man. Without one the next motion begins at rest.
   */
  boolean held(long now) {
    settle(now);
    boolean held = drag.isPresent() || pad.isPresent() || down.stream().anyMatch(key -> !spent.contains(key));
    if (!held) {
      rest();
    }
    return held;
  }

  /** Ends the motion; keys that are down must come up first. */
  void letGo() {
    spent.addAll(down);
    drag = Optional.empty();
    padSpent |= pad.isPresent();
    pad = Optional.empty();
    rest();
  }

  /** Forgets all keys, because releases will not be seen: the focus is gone. A gamepad needs none. */
  void forget() {
    down.clear();
    leaving.clear();
    spent.clear();
    half = false;
    dragEnd();
    if (pad.isEmpty()) {
      rest();
    }
  }

  /** Where the stick is held. */
  Stick stick(long now) {
    settle(now);
    Stick held = drag.or(() -> pad).orElseGet(this::keys);
    return half ? held.times(HALF) : held;
  }

  /** The speed to command now, on the way to what is wanted; zero at once when nobody holds on. */
  Speed step(long now, Limits limits) {
    if (!held(now)) {
      return rest();
    }
    double seconds = lastStep.map(last -> (now - last) * SECONDS_PER_NANO).orElse(FIRST_STEP_SECONDS);
    lastStep = Optional.of(now);
    speed = speed.toward(limits.at(stick(now)), limits, Math.clamp(seconds, 0.0, LONGEST_STEP_SECONDS));
    return speed;
  }

  /** The speed of the last step. */
  Speed speed() {
    return speed;
  }

  private Speed rest() {
    lastStep = Optional.empty();
    speed = Speed.ZERO;
    return speed;
  }

  private Stick keys() {
    return down.stream().filter(key -> !spent.contains(key)).map(DriveKey::stick).reduce(Stick.REST, Stick::with);
  }

  private void settle(long now) {
    leaving.entrySet().removeIf(entry -> now - entry.getValue() >= GRACE_NANOS && gone(entry.getKey()));
  }

  private boolean gone(DriveKey key) {
    spent.remove(key);
    return down.remove(key);
  }
}
