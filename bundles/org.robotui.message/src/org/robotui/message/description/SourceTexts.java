package org.robotui.message.description;

import java.util.Optional;
import org.robotui.message.DefinitionException;
import org.robotui.message.Generation;
import org.robotui.message.MessageSchema;

/** The texts that a node sends with a description: they have constants, if they are of the same type. */
final class SourceTexts {

  private static final String SEPARATOR = "\n" + "=".repeat(80) + "\nMSG: ";

  private SourceTexts() {}

  /** The type by its texts; empty where one is missing, cannot be read, or says something else than the description. */
  static Optional<MessageSchema> schema(DescribedType type) {
    String main = type.description().main().typeName();
    Optional<TypeName> name = TypeName.parse(main);
    if (name.isEmpty() || !type.sources().containsKey(main)) {
      return Optional.empty();
    }
    StringBuilder text = new StringBuilder(type.sources().get(main));
    type.sources().forEach((each, source) -> {
      if (!each.equals(main)) {
        text.append(SEPARATOR).append(each).append('\n').append(source);
      }
    });
    try {
      MessageSchema schema = MessageSchema.parse(main, text.toString(), Generation.ROS2);
      boolean same = TypeDescription.of(name.get(), schema).hash().equals(type.description().hash());
      return same ? Optional.of(schema) : Optional.empty();
    } catch (DefinitionException | IllegalArgumentException e) {
      return Optional.empty();
    }
  }
}
