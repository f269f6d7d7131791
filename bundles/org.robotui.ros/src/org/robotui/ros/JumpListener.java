package org.robotui.ros;

/** Hears when a node's time goes backwards. */
@FunctionalInterface
public interface JumpListener {

  /**
   * Simulated time jumped back, as when a simulation is reset or a bag starts again. Called on an I/O thread; must not
   * block.
   *
   * @param fromNanos the time before, in nanoseconds since the epoch of the clock
   * @param toNanos the time after
   */
  void onJumpBack(long fromNanos, long toNanos);
}
