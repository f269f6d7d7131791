package org.robotui.ros;

/**
 * A node's time: this machine's, or that of {@code /clock} while {@code /use_sim_time} is true. Any thread may read it.
 */
public interface NodeClock {

  /**
   * The time.
   *
   * @return nanoseconds since the epoch; zero while simulated time has not started
   */
  long nowNanos();

  /**
   * Whether the time comes from {@code /clock}.
   *
   * @return true while {@code /use_sim_time} is true
   */
  boolean isSimulated();

  /**
   * Listens to jumps back.
   *
   * @param listener hears of them
   * @return closing it ends the subscription
   */
  AutoCloseable onJumpBack(JumpListener listener);
}
