package org.robotui.api.port;

import org.robotui.data.Data;

/**
 * Sends commands to a robot.
 *
 * @param <T> the type of the commands
 */
@FunctionalInterface
public interface CommandSink<T extends Data> {
  /**
   * Sends one command now or not at all: it must not be queued over a reconnection. Called on a sender thread that
   * serves this robot interface alone, never the display thread. It should return within 20 ms; a call that blocks for
   * a second is fenced, and no further command goes to the port.
   *
   * @param command the command, limited already
   * @return whether it went out
   */
  Sent send(T command);

  /**
   * Says zero since the robot's stop is latched, on the same thread and by the same rules as {@link #send}. It is
   * called once, again while the robot reports motion, and where we drove also over a reconnection. Where we never
   * drove, it must have no effect but that of the zero itself: nothing is opened or started for it, and what is no main
   * motion of the robot answers {@link Sent.Unneeded}.
   *
   * @param zero the command that stops
   * @param ours whether we drove here, so that the stop is ours to bring about
   * @return whether it went out
   */
  default Sent stop(T zero, boolean ours) {
    return send(zero);
  }

  /** Whether a command went out. */
  sealed interface Sent {
    /** It was handed to the network. */
    record Out() implements Sent {}

    /**
     * It was not.
     *
     * @param reason a sentence for users
     */
    record Refused(String reason) implements Sent {}

    /**
     * It was not, and need not be: a stop for what we never drove and what is no main motion of the robot. It is not
     * said here again.
     */
    record Unneeded() implements Sent {}
  }
}
