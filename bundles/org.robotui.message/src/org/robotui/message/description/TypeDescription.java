package org.robotui.message.description;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.robotui.message.ActionSchema;
import org.robotui.message.DefinitionException;
import org.robotui.message.MessageSchema;
import org.robotui.message.ServiceSchema;

/**
 * A type with all it refers to, as nodes of ROS 2 describe it to others.
 *
 * @param main the type
 * @param referenced all types that it refers to, directly or not, in any order
 */
public record TypeDescription(StructDescription main, List<StructDescription> referenced) {

  /** Copies the types. */
  public TypeDescription {
    Objects.requireNonNull(main, "main");
    referenced = List.copyOf(referenced);
  }

  /**
   * Describes a message.
   *
   * @param name the name of the message, which may be a part of a service or of an action
   * @param schema the message, read as a definition of ROS 2
   * @return its description
   */
  public static TypeDescription of(TypeName name, MessageSchema schema) {
    return new DescriptionMaker(name).message(schema);
  }

  /**
   * Describes a service.
   *
   * @param name the name of the service, which may be one of an action
   * @param schema the service, read as a definition of ROS 2
   * @return its description, with the event that is made of it
   */
  public static TypeDescription of(TypeName name, ServiceSchema schema) {
    return new DescriptionMaker(name).service(schema);
  }

  /**
   * Describes an action.
   *
   * @param name the name of the action
   * @param schema the action
   * @return its description, with all services and messages that are made of it
   */
  public static TypeDescription of(TypeName name, ActionSchema schema) {
    return new DescriptionMaker(name).action(schema);
  }

  /**
   * The sum of this type.
   *
   * @return as peers announce it
   */
  public TypeHash hash() {
    return TypeHash.of(this);
  }

  /**
   * The description of a type that this one refers to.
   *
   * @param typeName the name of three parts
   * @return the type with what it refers to in turn
   * @throws IllegalArgumentException if this description has no such type
   */
  public TypeDescription part(String typeName) {
    Map<String, StructDescription> known =
        referenced.stream().collect(Collectors.toMap(StructDescription::typeName, Function.identity(), (a, b) -> a));
    StructDescription start = known.get(typeName);
    if (start == null) {
      throw new IllegalArgumentException(main.typeName() + " has no part " + typeName);
    }
    List<StructDescription> reached = new ArrayList<>(List.of(start));
    for (int i = 0; i < reached.size(); i++) {
      for (FieldDescription field : reached.get(i).fields()) {
        StructDescription next = known.get(field.nestedTypeName());
        if (next != null && !reached.contains(next)) {
          reached.add(next);
        }
      }
    }
    return new TypeDescription(start, reached.subList(1, reached.size()));
  }

  /**
   * Makes a message type of the description of one.
   *
   * @return the type, whose text is written from the description; it has no constants, as descriptions have none
   * @throws DefinitionException if a type is missing, broken, recursive, nested too deeply, or needs what no message
   * has, such as a character of 128 bits
   */
  public MessageSchema schema() throws DefinitionException {
    return DescribedText.schema(this);
  }
}
