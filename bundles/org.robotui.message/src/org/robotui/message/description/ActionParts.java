package org.robotui.message.description;

import java.util.List;

/** What an action is made of. */
final class ActionParts {

  /** Its messages. */
  static final List<String> MESSAGES = List.of("Goal", "Result", "Feedback", "FeedbackMessage");

  /** Its services. */
  static final List<String> SERVICES = List.of("SendGoal", "GetResult");

  private ActionParts() {}
}
