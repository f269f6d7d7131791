package org.robotui.ros2;

/** A node's time: this machine's, or that of {@code /clock}. Any thread may read it. */
public interface Ros2Clock {

  /** Hears when a node's time goes backwards. */
  @FunctionalInterface
  interface Ros2JumpListener {

    /**
     * Simulated time jumped back, as when a simulation is reset or a bag starts again. Called on the receiving thread;
     * must not block.
     *
     * @param fromNanos the time before, in nanoseconds since the epoch of the clock
     * @param toNanos the time after
     */
    void onJumpBack(long fromNanos, long toNanos);
  }

  /**
   * The time.
   *
   * @return nanoseconds since the epoch; zero while simulated time has not started
   */
  long nowNanos();

  /**
   * Whether the time comes from {@code /clock}.
   *
   * @return what was last said
   */
  boolean isSimulated();

  /**
   * Says where the time comes from. In ROS 2 each node decides by its own parameter {@code use_sim_time}.
   *
   * @param simulated whether it comes from {@code /clock}
   */
  void simulated(boolean simulated);

  /**
   * Listens to jumps back.
   *
   * @param listener hears of them
   * @return closing it ends the subscription
   */
  AutoCloseable onJumpBack(Ros2JumpListener listener);
}
