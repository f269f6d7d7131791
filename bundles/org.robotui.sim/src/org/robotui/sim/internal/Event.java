package org.robotui.sim.internal;

/**
 * Something worth a line in the log.
 *
 * @param severity how bad
 * @param source part of the robot
 * @param text for a user
 */
public record Event(Severity severity, String source, String text) {
  /** How bad an event is. */
  public enum Severity {
    INFO,
    WARN,
    ERROR
  }
}
