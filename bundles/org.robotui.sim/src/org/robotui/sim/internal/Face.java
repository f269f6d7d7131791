package org.robotui.sim.internal;

import java.io.IOException;
import java.util.SequencedMap;

/** How the robot appears in one framework. Several faces may show the same robot. */
public interface Face extends AutoCloseable {
  /** What is asked for before there is a robot, such as settings that users keep in the framework. */
  default Settings adjust(Settings settings) {
    return settings;
  }

  /**
   * Offers a robot to clients; once, before the first step.
   *
   * @param stamp the time now, nanoseconds
   * @throws IOException if that is not possible; for a user to read
   */
  void show(SimulatedRobot robot, long stamp) throws IOException;

  /**
   * Sends what is due with a step that was made. For one thread.
   *
   * @param step counts the steps, from 1
   * @param stamp the time now, nanoseconds
   */
  void step(long step, long stamp);

  /** The environment variables by which clients find the robot, from {@link #show} on. */
  SequencedMap<String, String> addresses();

  /** Ends all that clients have, in bounded time. */
  @Override
  void close();
}
