package org.robotui.message;

import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * An action type of ROS 2 with all the types it refers to, and with the services and messages that are made of it.
 *
 * @param type the full name, such as {@code nav2_msgs/NavigateToPose}
 * @param goal what is asked for
 * @param result what comes of it
 * @param feedback what is told on the way
 * @param sendGoal the service that takes a goal with its identifier
 * @param getResult the service that answers when the goal has ended
 * @param feedbackMessage feedback with the identifier of the goal
 */
public record ActionSchema(String type, MessageSchema goal, MessageSchema result, MessageSchema feedback,
    ServiceSchema sendGoal, ServiceSchema getResult, MessageSchema feedbackMessage) {

  /**
   * Puts a type together from its definition and a source of the types it refers to.
   *
   * @param definition the action type
   * @param source where to find message types
   * @return the complete type
   * @throws DefinitionException if a type is missing, broken, recursive, or nested too deeply
   */
  public static ActionSchema resolve(ActionDefinition definition, DefinitionSource source) throws DefinitionException {
    Map<String, MessageDefinition> own = Stream.of(definition.goal(), definition.result(), definition.feedback())
        .collect(Collectors.toMap(MessageDefinition::type, Function.identity()));
    DefinitionSource all = type -> own.containsKey(type) ? Optional.of(own.get(type)) : source.find(type);
    return new ActionSchema(definition.type(), MessageSchema.resolve(definition.goal(), all),
        MessageSchema.resolve(definition.result(), all), MessageSchema.resolve(definition.feedback(), all),
        ServiceSchema.resolve(definition.sendGoal(), all), ServiceSchema.resolve(definition.getResult(), all),
        MessageSchema.resolve(definition.feedbackMessage(), all));
  }
}
