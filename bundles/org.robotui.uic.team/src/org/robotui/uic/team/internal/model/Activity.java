package org.robotui.uic.team.internal.model;

import java.util.Locale;
import org.robotui.ui.Health;

/** What a robot is doing, what needs somebody first. */
public enum Activity {
  /** No link to it. */
  LOST(Health.BAD),
  /** It is there, but does not say where it is any more. */
  SILENT(Health.BAD),
  /** What it said is old. */
  STALE(Health.STALE),
  /** The stop is latched. */
  STOPPED(Health.BAD),
  /** It has not said anything yet. */
  WAITING(Health.WAITING),
  /** It moves. */
  DRIVING(Health.OK),
  /** It does not move. */
  STANDING(Health.OK);

  private final Health health;

  Activity(Health health) {
    this.health = health;
  }

  /** Its dot. */
  public Health health() {
    return health;
  }

  /** Its word. */
  public String word() {
    return name().toLowerCase(Locale.ROOT);
  }
}
