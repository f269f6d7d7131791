package org.robotui.sim.internal.robot;

/** Holds the last speed command until it is too old. For one thread. */
public final class CommandGate {
  private final double timeout;
  private Speed command = Speed.ZERO;
  private double receivedAt = Double.NEGATIVE_INFINITY;
  private boolean live;

  /** @param timeout seconds */
  public CommandGate(double timeout) {
    this.timeout = timeout;
  }

  public void accept(Speed wish, double now) {
    command = wish;
    receivedAt = now;
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
    if (!live || now - receivedAt < timeout) {
      return false;
    }
    live = false;
    return !command.isZero();
  }
}
