package org.robotui.api.command;

/**
 * Who gives commands.
 *
 * @param id unique within this process
 * @param label as users read it, for example {@code You}
 * @param kind what stands behind
 */
public record Principal(String id, String label, Kind kind) {
  /** What stands behind a principal. */
  public enum Kind {
    /** A person at a window: silent display or lost focus ends streaming commands. */
    WINDOW,
    /** A person at a terminal. */
    TERMINAL,
    /** A program. */
    SCRIPT
  }
}
