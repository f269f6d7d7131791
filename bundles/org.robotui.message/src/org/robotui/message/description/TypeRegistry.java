package org.robotui.message.description;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiFunction;
import org.robotui.message.ActionSchema;
import org.robotui.message.DefinitionException;
import org.robotui.message.DefinitionSource;
import org.robotui.message.Definitions;
import org.robotui.message.Generation;
import org.robotui.message.MessageDefinition;
import org.robotui.message.MessageSchema;
import org.robotui.message.SchemaLookup;
import org.robotui.message.ServiceSchema;
import org.robotui.net.collection.LruMap;

/**
 * All types of ROS 2 that are known, by name and sum: those shipped with this library, those installed on this machine,
 * and those that nodes described. May read files: not for I/O threads. Safe for several threads.
 */
public final class TypeRegistry {

  private static final int MAX_LEARNED = 500;

  private final List<Definitions> places;
  private final Map<TypeHash, TypeKnowledge> learned = new LruMap<>(MAX_LEARNED);

  /**
   * Creates a registry.
   *
   * @param local the definitions of this machine, read as those of ROS 2
   */
  public TypeRegistry(Definitions local) {
    places = List.of(Definitions.shipped(Generation.ROS2), local);
  }

  /**
   * Remembers what a node described.
   *
   * @param name the type that was asked for
   * @param wanted the sum that it must have
   * @param answer what the node described
   * @return the sum of the description, or why it cannot be used
   */
  public SchemaLookup<TypeHash> learn(TypeName name, TypeHash wanted, DescribedType answer) {
    if (!answer.description().main().typeName().equals(name.toString())) {
      return new SchemaLookup.Missing<>("asked for " + name + ", a node described another type");
    }
    TypeHash sum = answer.description().hash();
    if (!sum.equals(wanted)) {
      return new SchemaLookup.Missing<>("the description of " + name + " that a node sent has the sum " + sum.brief()
          + ", but the type announced has " + wanted.brief());
    }
    synchronized (learned) {
      learned.put(sum, new TypeKnowledge.Described(answer));
    }
    return new SchemaLookup.Found<>(sum);
  }

  /**
   * A type of messages.
   *
   * @param name a message, a request or response, or a part of an action
   * @param hash the sum that the peer announced; empty where it announced none, as before Iron
   * @return the type, or why there is none
   */
  public SchemaLookup<MessageSchema> message(TypeName name, Optional<TypeHash> hash) {
    return find(name, hash, knowledge -> knowledge.message(name), TypeDescription::of);
  }

  /**
   * A type of services.
   *
   * @param name its name, also of the services of an action, such as {@code nav2_msgs/action/NavigateToPose_SendGoal}
   * @param hash the sum that the peer announced; empty where it announced none
   * @return the type, or why there is none
   */
  public SchemaLookup<ServiceSchema> service(TypeName name, Optional<TypeHash> hash) {
    return find(name, hash, knowledge -> knowledge.service(name), TypeDescription::of);
  }

  /**
   * A type of actions.
   *
   * @param name its name
   * @param hash the sum of the whole action; empty where it is not known, as peers do not announce it
   * @return the type, or why there is none
   */
  public SchemaLookup<ActionSchema> action(TypeName name, Optional<TypeHash> hash) {
    return find(name, hash, knowledge -> knowledge.action(name), TypeDescription::of);
  }

  /** What one place knows, if it does. */
  @FunctionalInterface
  private interface Question<S> {
    Optional<S> ask(TypeKnowledge place) throws DefinitionException;
  }

  private <S> SchemaLookup<S> find(TypeName name, Optional<TypeHash> hash, Question<S> question,
      BiFunction<TypeName, S, TypeDescription> describe) {
    String reason = "";
    for (TypeKnowledge place : knowledge(hash)) {
      try {
        Optional<S> found = question.ask(place);
        if (found.isPresent()) {
          Optional<String> difference =
              hash.flatMap(wanted -> differs(name, wanted, describe.apply(name, found.get())));
          if (difference.isEmpty()) {
            return new SchemaLookup.Found<>(found.get());
          }
          reason = difference.get();
        }
      } catch (DefinitionException e) {
        reason = e.getMessage();
      }
    }
    return new SchemaLookup.Missing<>(reason.isEmpty() ? nowhere(name) : reason);
  }

  private static Optional<String> differs(TypeName name, TypeHash wanted, TypeDescription found) {
    TypeHash sum = found.hash();
    return sum.equals(wanted) ? Optional.empty()
        : Optional.of("the robot's " + name + " has the sum " + wanted.brief() + ", the one known here "
            + sum.brief() + ": the definitions differ");
  }

  private static String nowhere(TypeName name) {
    return "no definition of " + name + " is shipped, installed on this machine (AMENT_PREFIX_PATH, COLCON_PREFIX_PATH)"
        + " or described by a node";
  }

  private List<TypeKnowledge> knowledge(Optional<TypeHash> hash) {
    synchronized (learned) {
      TypeKnowledge described = hash.map(learned::get).orElse(null);
      if (described != null) {
        return List.of(described);
      }
    }
    return List.of(defined(0), defined(1));
  }

  /** The definitions of one place; what they refer to is looked for there first. */
  private TypeKnowledge defined(int first) {
    Definitions own = places.get(first);
    Definitions other = places.get(1 - first);
    DefinitionSource all = type -> {
      Optional<MessageDefinition> found = own.find(type);
      return found.isPresent() ? found : other.find(type);
    };
    return new TypeKnowledge.Defined(own, all);
  }
}
