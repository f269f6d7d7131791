package org.robotui.api.session;

import java.io.IOException;

/** Opens the sessions of a robot interface, one after another. */
@FunctionalInterface
public interface SessionFactory {
  /**
   * Opens a session, on the thread of the robot interface. It may block; at the end of the robot interface the thread
   * is interrupted.
   *
   * @param scope what the session needs beside itself and is closed after it, also where opening it fails
   * @return the session
   * @throws IOException where it cannot be opened, with the reason for users; it is tried again later
   * @throws InterruptedException where the robot interface was closed
   */
  RobotSession open(SessionScope scope) throws IOException, InterruptedException;
}
