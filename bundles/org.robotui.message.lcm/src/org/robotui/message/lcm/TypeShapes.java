package org.robotui.message.lcm;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import org.robotui.data.record.FieldShape;
import org.robotui.data.record.RecordShape;
import org.robotui.lcm.type.Dimension;
import org.robotui.lcm.type.LcmType;
import org.robotui.lcm.type.MemberDefinition;
import org.robotui.lcm.type.Primitive;
import org.robotui.lcm.type.TypeDefinition;
import org.robotui.lcm.type.TypeLibrary;

/** The forms of LCM messages. */
public final class TypeShapes {
  private final TypeLibrary types;
  private final Deque<String> within = new ArrayDeque<>();

  private TypeShapes(TypeLibrary types) {
    this.types = types;
  }

  /**
   * The form of messages of a type.
   *
   * @param type the type
   * @param types all types
   * @return its form
   */
  public static RecordShape of(LcmType type, TypeLibrary types) {
    return new TypeShapes(types).record(type.definition());
  }

  private RecordShape record(TypeDefinition.Struct struct) {
    return new RecordShape(struct.name(),
        struct.members().stream().map(m -> new RecordShape.Field(m.name(), member(m))).toList(),
        struct.constants().stream().map(c -> new RecordShape.Constant(c.name(), c.text())).toList());
  }

  private FieldShape member(MemberDefinition member) {
    FieldShape shape = Primitive.of(member.type()).map(TypeShapes::primitive).orElseGet(() -> nested(member.type()));
    for (Dimension dimension : member.dimensions().reversed()) {
      shape = new FieldShape.Many(shape, dimension instanceof Dimension.Fixed fixed ? fixed.size() : 0);
    }
    return shape;
  }

  /** Types may hold themselves; the inner one is cut off. What is no struct is an enum. */
  private FieldShape nested(String name) {
    Optional<LcmType> type = types.type(name);
    if (type.isEmpty()) {
      return primitive(Primitive.INT32);
    }
    if (within.contains(name)) {
      return new FieldShape.Nested(new RecordShape(name, List.of(), List.of()));
    }
    within.push(name);
    FieldShape shape = new FieldShape.Nested(record(type.get().definition()));
    within.pop();
    return shape;
  }

  private static FieldShape primitive(Primitive type) {
    return switch (type) {
      case INT8, INT16, INT32, INT64 -> new FieldShape.Whole(type.size() * Byte.SIZE, true);
      case BYTE -> new FieldShape.Whole(Byte.SIZE, false);
      case FLOAT, DOUBLE -> new FieldShape.Real(type.size() * Byte.SIZE);
      case BOOLEAN -> new FieldShape.Flag();
      case STRING -> new FieldShape.Text();
    };
  }
}
