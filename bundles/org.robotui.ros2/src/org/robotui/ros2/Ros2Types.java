package org.robotui.ros2;

import java.time.Duration;
import java.util.Optional;
import org.robotui.message.ActionSchema;
import org.robotui.message.MessageSchema;
import org.robotui.message.SchemaLookup;
import org.robotui.message.ServiceSchema;
import org.robotui.message.description.TypeHash;
import org.robotui.message.description.TypeName;
import org.robotui.message.description.TypeRegistry;
import org.robotui.ros2.name.Ros2Name;

/**
 * Finds types: those shipped, those installed on this machine, and at last, for messages, those that the nodes of the
 * domain describe when asked. All calls but {@link #registry} may read files and wait for nodes: not for the receiving
 * thread.
 */
public interface Ros2Types {

  /**
   * What is known without asking nodes.
   *
   * @return the registry, which remembers what nodes described
   */
  TypeRegistry registry();

  /**
   * The type of a topic's messages, in the version that its publishers announce.
   *
   * @param topic the topic
   * @param patience how long nodes may take to describe it
   * @return the type, or why there is none and what would help
   */
  SchemaLookup<TypedMessage> topic(Ros2Name topic, Duration patience);

  /**
   * A type of messages.
   *
   * @param name its name
   * @param hash the sum that a peer announced
   * @param patience how long nodes may take to describe it
   * @return the type, or why there is none and what would help
   */
  SchemaLookup<MessageSchema> message(TypeName name, Optional<TypeHash> hash, Duration patience);

  /**
   * The type of a service, in the version that its server announces.
   *
   * @param service the service
   * @return the type, or why there is none and what would help
   */
  SchemaLookup<TypedService> service(Ros2Name service);

  /**
   * The type of an action.
   *
   * @param action the action
   * @return the type, or why there is none and what would help
   */
  SchemaLookup<TypedAction> action(Ros2Name action);

  /**
   * A topic's type.
   *
   * @param name its name
   * @param schema the type
   */
  record TypedMessage(TypeName name, MessageSchema schema) {}

  /**
   * A service's type.
   *
   * @param name its name
   * @param schema the type
   */
  record TypedService(TypeName name, ServiceSchema schema) {}

  /**
   * An action's type.
   *
   * @param name its name
   * @param schema the type
   */
  record TypedAction(TypeName name, ActionSchema schema) {}
}
