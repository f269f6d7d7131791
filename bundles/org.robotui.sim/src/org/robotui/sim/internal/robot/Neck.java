package org.robotui.sim.internal.robot;

import java.util.Optional;

/** Moves the head: it looks around by itself until somebody says where to look. For one thread. */
public final class Neck {
  /** To either side, radians. */
  public static final double MOST_PAN = 1.2;
  /** Up and down, radians. */
  public static final double MOST_TILT = 0.6;
  /** Radians per second. */
  public static final double FASTEST = 1.5;

  private Head head = Head.at(0);
  private Optional<Look> wish = Optional.empty();

  /**
   * Where to look, and how fast to get there.
   *
   * @param pan to the left, radians
   * @param tilt downwards, radians
   * @param panSpeed radians per second, not negative
   * @param tiltSpeed radians per second, not negative
   */
  public record Look(double pan, double tilt, double panSpeed, double tiltSpeed) {}

  public Head head() {
    return head;
  }

  /** Looks there, within what the neck can do, and stays so. */
  public void look(Look there) {
    wish = Optional.of(new Look(
        Math.clamp(there.pan(), -MOST_PAN, MOST_PAN), Math.clamp(there.tilt(), -MOST_TILT, MOST_TILT),
        Math.clamp(there.panSpeed(), 0, FASTEST), Math.clamp(there.tiltSpeed(), 0, FASTEST)));
  }

  /** Looks around by itself again. */
  public void release() {
    wish = Optional.empty();
  }

  /**
   * Goes on.
   *
   * @param time seconds since the start of the simulation
   * @param dt seconds since the last call
   */
  public void step(double time, double dt) {
    head = wish.map(look -> turned(look, dt)).orElseGet(() -> Head.at(time));
  }

  private Head turned(Look look, double dt) {
    double pan = Math.clamp(look.pan() - head.pan(), -look.panSpeed() * dt, look.panSpeed() * dt);
    double tilt = Math.clamp(look.tilt() - head.tilt(), -look.tiltSpeed() * dt, look.tiltSpeed() * dt);
    return new Head(head.pan() + pan, head.tilt() + tilt, pan / dt, tilt / dt);
  }
}
