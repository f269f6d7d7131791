package org.robotui.sim.internal;

/**
 * What became of the last goal.
 *
 * @param number of the goal, from 1; 0 before the first
 * @param id the name it was given
 * @param phase how far it got
 * @param text for a user
 */
public record GoalStatus(int number, String id, Phase phase, String text) {
  public static final GoalStatus NONE = new GoalStatus(0, "", Phase.SUCCEEDED, "");

  /** How far a goal got. */
  public enum Phase {
    ACTIVE,
    PREEMPTED,
    SUCCEEDED,
    ABORTED,
    REJECTED
  }
}
