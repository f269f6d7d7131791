package org.robotui.ros.action;

import java.util.Objects;
import org.robotui.message.MessageRegistry;
import org.robotui.message.MessageSchema;
import org.robotui.message.SchemaLookup;

/**
 * What is to be known of an action's type to serve it.
 *
 * @param type what clients know of it
 * @param result the message that carries a result, such as {@code move_base_msgs/MoveBaseActionResult}
 * @param feedback the message that carries feedback, such as {@code move_base_msgs/MoveBaseActionFeedback}
 */
public record ActionWire(ActionType type, MessageSchema result, MessageSchema feedback) {

  /** Checks that nothing is missing. */
  public ActionWire {
    Objects.requireNonNull(type, "type");
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
  public static SchemaLookup<ActionWire> find(String name, MessageRegistry registry) {
    return switch (ActionType.find(name, registry)) {
      case SchemaLookup.Missing<ActionType> missing -> new SchemaLookup.Missing<>(missing.reason());
      case SchemaLookup.Found<ActionType> found -> of(found.schema(), registry.message(name + "Result"),
          registry.message(name + "Feedback"));
    };
  }

  private static SchemaLookup<ActionWire> of(ActionType type, SchemaLookup<MessageSchema> result,
      SchemaLookup<MessageSchema> feedback) {
    return switch (result) {
      case SchemaLookup.Missing<MessageSchema> missing -> new SchemaLookup.Missing<>(missing.reason());
      case SchemaLookup.Found<MessageSchema> first -> switch (feedback) {
        case SchemaLookup.Missing<MessageSchema> missing -> new SchemaLookup.Missing<>(missing.reason());
        case SchemaLookup.Found<MessageSchema> second -> new SchemaLookup.Found<>(
            new ActionWire(type, first.schema(), second.schema()));
      };
    };
  }
}
