package org.robotui.message;

import java.util.List;

/**
 * One action type of ROS 2 as its definition says it.
 *
 * @param type the full name, such as {@code nav2_msgs/NavigateToPose}
 * @param text the definition's text as found
 * @param goal the part before the first line {@code ---}; its type is named {@code <type>_Goal}
 * @param result the part before the second; its type is named {@code <type>_Result}
 * @param feedback the part after it; its type is named {@code <type>_Feedback}
 */
public record ActionDefinition(String type, String text, MessageDefinition goal, MessageDefinition result,
    MessageDefinition feedback) {

  private static final int PARTS = 3;

  /**
   * Reads a definition.
   *
   * @param type the full name
   * @param text the text of the {@code .action} file
   * @return the action type
   * @throws DefinitionException if it is no action definition
   */
  public static ActionDefinition parse(String type, String text) throws DefinitionException {
    String plain = Generation.plainName(type);
    List<String> parts = DefinitionParts.of(text);
    if (parts.size() != PARTS) {
      throw new DefinitionException(plain, "expected two lines '---' between goal, result and feedback, found "
          + (parts.size() - 1));
    }
    return new ActionDefinition(plain, text, part(plain + "_Goal", parts.get(0)), part(plain + "_Result", parts.get(1)),
        part(plain + "_Feedback", parts.get(2)));
  }

  private static MessageDefinition part(String type, String text) throws DefinitionException {
    return DefinitionParser.parse(type, text, Generation.ROS2);
  }

  /** The service that takes a goal. */
  ServiceDefinition sendGoal() throws DefinitionException {
    return ServiceDefinition.parse(type + "_SendGoal", """
        unique_identifier_msgs/UUID goal_id
        %s goal
        ---
        bool accepted
        builtin_interfaces/Time stamp
        """.formatted(goal.type()), Generation.ROS2);
  }

  /** The service that answers when the goal has ended. */
  ServiceDefinition getResult() throws DefinitionException {
    return ServiceDefinition.parse(type + "_GetResult", """
        unique_identifier_msgs/UUID goal_id
        ---
        int8 status
        %s result
        """.formatted(result.type()), Generation.ROS2);
  }

  /** What is published while the goal is worked on. */
  MessageDefinition feedbackMessage() throws DefinitionException {
    return part(type + "_FeedbackMessage", """
        unique_identifier_msgs/UUID goal_id
        %s feedback
        """.formatted(feedback.type()));
  }
}
