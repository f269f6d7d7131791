package org.robotui.ros.action;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.robotui.message.MessageRegistry;
import org.robotui.message.MessageSchema;
import org.robotui.message.SchemaLookup;

/**
 * What is to be known of an action's type to send goals and to describe it. Results and feedback are decoded by what
 * the server announces.
 *
 * @param name the type's name, such as {@code move_base_msgs/MoveBaseAction}
 * @param sent the message that carries a goal, such as {@code move_base_msgs/MoveBaseActionGoal}
 * @param goal the goal itself, such as {@code move_base_msgs/MoveBaseGoal}: what a user fills in
 * @param result the result itself, such as {@code move_base_msgs/MoveBaseResult}
 * @param feedback what the server tells on the way, such as {@code move_base_msgs/MoveBaseFeedback}
 */
public record ActionType(String name, MessageSchema sent, MessageSchema goal, MessageSchema result,
    MessageSchema feedback) {

  private static final String SUFFIX = "Action";

  /** Checks that nothing is missing. */
  public ActionType {
    Objects.requireNonNull(name, "name");
    Objects.requireNonNull(sent, "sent");
    Objects.requireNonNull(goal, "goal");
    Objects.requireNonNull(result, "result");
    Objects.requireNonNull(feedback, "feedback");
  }

  /**
   * Finds the definitions of a type. May read files: not for I/O threads.
   *
   * @param name the type's name; it ends in {@code Action}
   * @param registry knows the definitions
   * @return the type, or which definition is missing
   */
  public static SchemaLookup<ActionType> find(String name, MessageRegistry registry) {
    if (!name.endsWith(SUFFIX)) {
      return new SchemaLookup.Missing<>("'" + name + "' is no type of an action: its name does not end in " + SUFFIX);
    }
    String base = name.substring(0, name.length() - SUFFIX.length());
    List<MessageSchema> parts = new ArrayList<>();
    for (String part : List.of(name + "Goal", base + "Goal", base + "Result", base + "Feedback")) {
      switch (registry.message(part)) {
        case SchemaLookup.Missing<MessageSchema> missing -> {
          return new SchemaLookup.Missing<>(missing.reason());
        }
        case SchemaLookup.Found<MessageSchema> found -> parts.add(found.schema());
      }
    }
    return new SchemaLookup.Found<>(new ActionType(name, parts.get(0), parts.get(1), parts.get(2), parts.get(3)));
  }
}
