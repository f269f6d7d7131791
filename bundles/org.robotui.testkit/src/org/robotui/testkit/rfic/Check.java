package org.robotui.testkit.rfic;

import java.util.Optional;

/**
 * One thing that a robot interface keeps.
 *
 * @param name a sentence about the robot interface
 * @param lacking why it cannot be checked with this framework, if so; such a check is not to be run but shown as
 * skipped
 * @param body checks it
 */
public record Check(String name, Optional<String> lacking, Body body) {
  /** Checks something. */
  @FunctionalInterface
  public interface Body {
    /**
     * Checks.
     *
     * @throws Exception where the robot of the test does not work; an {@link AssertionError} says that the robot
     * interface does not
     */
    void run() throws Exception;
  }

  /**
   * Checks it.
   *
   * @throws Exception where the robot of the test does not work; an {@link AssertionError} says that the robot
   * interface does not
   */
  public void run() throws Exception {
    body.run();
  }

  @Override
  public String toString() {
    return name;
  }
}
