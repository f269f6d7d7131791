package org.robotui.api;

/**
 * A client of a robotics framework. It turns messages into data and commands into messages, reconnects by itself, and
 * has no effect on the robot beyond what it is told to send.
 */
public interface Rfic extends AutoCloseable {
  /** Starts connecting. Called once on a core worker; must return within a second and go on in threads of its own. */
  void start();

  /**
   * Ends everything. What this instance drives is stopped, what others drive is left alone; no thread, socket or
   * registration of this instance is left when it returns, within two seconds also when the robot hangs. Called once on
   * a core worker, also when {@link #start} failed or was never called.
   */
  @Override
  void close();
}
