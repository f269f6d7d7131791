package org.robotui.api.session;

import java.io.IOException;
import java.util.Optional;
import java.util.function.BooleanSupplier;

/** One connection to a robot, and all that is offered through it, from its beginning to its end. */
public interface RobotSession {
  /**
   * Follows the robot, on the thread of the robot interface, and reports its link.
   *
   * @param over whether the robot interface was closed; to be asked again and again
   * @return why the session ended, for users; none where the next one is to be opened at once
   * @throws IOException where the connection breaks, with the reason for users
   * @throws InterruptedException where the robot interface was closed
   */
  Optional<String> follow(BooleanSupplier over) throws IOException, InterruptedException;

  /**
   * Stops what it drives, withdraws its offers and closes its connection, in a bounded time also where the robot hangs.
   * Called once, when {@link #follow} has ended or, at the end of the robot interface, on another thread beside it,
   * which it should end.
   */
  void close();
}
