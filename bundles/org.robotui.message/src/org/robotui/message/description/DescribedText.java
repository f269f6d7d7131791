package org.robotui.message.description;

import java.util.Optional;
import org.robotui.message.DefinitionException;
import org.robotui.message.Generation;
import org.robotui.message.MessageSchema;
import org.robotui.message.Primitive;

/** Writes descriptions as definitions of messages, so that there is one way from a type to what decodes it. */
final class DescribedText {

  private static final String SEPARATOR = "\n" + "=".repeat(80) + "\nMSG: ";
  /** What a message without fields has on the wire; a definition without fields says the same. */
  private static final String ONLY_MEMBER = "structure_needs_at_least_one_member";

  private DescribedText() {}

  static MessageSchema schema(TypeDescription description) throws DefinitionException {
    StringBuilder text = new StringBuilder(struct(description.main()));
    for (StructDescription each : description.referenced()) {
      text.append(SEPARATOR).append(each.typeName()).append('\n').append(struct(each));
    }
    return MessageSchema.parse(description.main().typeName(), text.toString(), Generation.ROS2);
  }

  private static String struct(StructDescription type) throws DefinitionException {
    StringBuilder text = new StringBuilder();
    for (FieldDescription field : type.fields()) {
      if (!field.name().equals(ONLY_MEMBER)) {
        text.append(typeOf(type, field)).append(' ').append(field.name()).append(initial(field)).append('\n');
      }
    }
    return text.toString();
  }

  private static String initial(FieldDescription field) {
    boolean fits = !field.defaultValue().isEmpty() && field.defaultValue().chars().noneMatch(Character::isISOControl);
    return fits ? " " + field.defaultValue() : "";
  }

  private static String typeOf(StructDescription type, FieldDescription field) throws DefinitionException {
    String element = element(type, field);
    if (field.typeId() < 0 || field.typeId() / FieldKind.ARRAY > FieldKind.SEQUENCE / FieldKind.ARRAY) {
      throw unknown(type, field);
    }
    return switch (FieldKind.arity(field.typeId())) {
      case FieldKind.ARRAY -> element + "[" + bound(type, field, field.capacity()) + "]";
      case FieldKind.BOUNDED_SEQUENCE -> element + "[<=" + bound(type, field, field.capacity()) + "]";
      case FieldKind.SEQUENCE -> element + "[]";
      default -> element;
    };
  }

  private static String element(StructDescription type, FieldDescription field) throws DefinitionException {
    int id = field.typeId() % FieldKind.ARRAY;
    if (id == FieldKind.NESTED) {
      return Generation.plainName(field.nestedTypeName());
    }
    Optional<Primitive> known = FieldKind.primitive(field.typeId());
    if (known.isEmpty()) {
      throw unknown(type, field);
    }
    boolean bounded = id == FieldKind.BOUNDED_STRING || id == FieldKind.BOUNDED_WSTRING;
    return known.get().rosName() + (bounded ? "<=" + bound(type, field, field.stringCapacity()) : "");
  }

  private static long bound(StructDescription type, FieldDescription field, long value) throws DefinitionException {
    if (value < 1 || value > Integer.MAX_VALUE) {
      throw new DefinitionException(type.typeName(),
          "field " + field.name() + " has the bound " + Long.toUnsignedString(value));
    }
    return value;
  }

  private static DefinitionException unknown(StructDescription type, FieldDescription field) {
    return new DefinitionException(type.typeName(),
        "field " + field.name() + " has type " + field.typeId() + ", which no message of this library has");
  }
}
