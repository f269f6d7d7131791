package org.robotui.ros.action;

import java.util.Objects;
import java.util.Optional;
import org.robotui.message.DynamicMessage;

/**
 * What became of a goal.
 *
 * @param end how it ended
 * @param text the server's words, or why the goal is lost
 * @param result the result without what actionlib wraps it in; empty if none came
 */
public record GoalOutcome(GoalEnd end, String text, Optional<DynamicMessage> result) {

  /** Checks that nothing is missing. */
  public GoalOutcome {
    Objects.requireNonNull(end, "end");
    Objects.requireNonNull(text, "text");
    Objects.requireNonNull(result, "result");
  }

  static GoalOutcome lost(String reason) {
    return new GoalOutcome(GoalEnd.LOST, reason, Optional.empty());
  }
}
