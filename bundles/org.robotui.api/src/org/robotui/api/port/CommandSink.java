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
   * Sends one command now or not at all: it must not be queued over a reconnection. Called on a sender thread that serves
   * this robot interface alone, never the display thread. It should return within 20 ms; a call that blocks for a second is
   * fenced, and no further command goes to the port.
   *
   * @param command the command, limited already
   * @return whether it went out
   */
  Sent send(T command);

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
  }
}
