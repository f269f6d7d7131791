package org.robotui.ui;

/** The states that differ in more than colour: each has a dot of its own shape and a word. */
public enum Health {
  /** Data comes. */
  OK(Role.GOOD),
  /** It works, but not as it should. */
  WARNING(Role.WARNING),
  /** It does not work. */
  BAD(Role.BAD),
  /** What is seen is old. */
  STALE(Role.WARNING),
  /** Connected, nothing came yet. */
  WAITING(Role.DIM),
  /** Nothing there. */
  NONE(Role.DIM);

  private final Role role;

  Health(Role role) {
    this.role = role;
  }

  /**
   * The colour of the dot.
   *
   * @return its role
   */
  public Role role() {
    return role;
  }
}
