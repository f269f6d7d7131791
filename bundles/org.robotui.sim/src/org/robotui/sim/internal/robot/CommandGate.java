package org.robotui.sim.internal.robot;

/** Holds the last speed command until it is too old. For one thread. */
public final class CommandGate {
  private Speed command = Speed.ZERO;
  private double validUntil = Double.NEGATIVE_INFINITY;
  private boolean live;

  /**
   * Takes a command.
   *
   * @param until when it is too old, on the clock of {@link #expire}
   */
  public void accept(Speed wish, double until) {
    command = wish;
    validUntil = until;
    live = true;
  }

  public void clear() {
    live = false;
  }

  public boolean isLive() {
    return live;
  }

  /** The command, zero when there is none. */
  public Speed command() {
    return live ? command : Speed.ZERO;
  }

  /** Drops a command that is too old; true if that stops a motion. */
  public boolean expire(double now) {
    if (!live || now < validUntil) {
      return false;
    }
    live = false;
    return !command.isZero();
  }
}
