package org.robotui.rfic.carmen.internal.call;

import java.util.ArrayList;
import java.util.List;
import org.robotui.carmen.format.IpcFormat;
import org.robotui.carmen.format.IpcPrimitive;
import org.robotui.carmen.message.FieldName;
import org.robotui.carmen.message.IpcForm;
import org.robotui.data.record.FieldShape;
import org.robotui.data.record.RecordShape;

/** The forms of messages, and their descriptions with units. */
final class CarmenShapes {
  private static final int BYTE = 8;
  private static final int WORD = 32;
  private static final int LONG = 64;

  private CarmenShapes() {}

  static RecordShape of(IpcForm form) {
    return shape(form.name(), form.format(), form.fields());
  }

  private static List<IpcFormat> members(IpcFormat format) {
    return switch (format) {
      case IpcFormat.Struct struct -> struct.members();
      case IpcFormat.Nothing nothing -> List.of();
      default -> List.of(format);
    };
  }

  private static RecordShape shape(String name, IpcFormat format, List<FieldName> names) {
    List<IpcFormat> members = members(format);
    List<RecordShape.Field> fields = new ArrayList<>();
    for (int i = 0; i < names.size(); i++) {
      fields.add(new RecordShape.Field(names.get(i).name(), field(members.get(i), names.get(i))));
    }
    return new RecordShape(name, fields, List.of());
  }

  private static FieldShape field(IpcFormat format, FieldName name) {
    return switch (format) {
      case IpcFormat.Single single -> primitive(single.type());
      case IpcFormat.Struct struct -> new FieldShape.Nested(shape(name.name(), struct, name.members()));
      case IpcFormat.FixedArray array -> new FieldShape.Many(field(array.element(), name), array.count());
      case IpcFormat.VariableArray array -> new FieldShape.Many(field(array.element(), name), 0);
      case IpcFormat.Pointer pointer -> field(pointer.target(), name);
      case IpcFormat.Opaque opaque -> new FieldShape.Many(new FieldShape.Whole(BYTE, false), opaque.bytes());
      case IpcFormat.Named named -> new FieldShape.Text();
      case IpcFormat.Nothing nothing -> new FieldShape.Text();
    };
  }

  private static FieldShape primitive(IpcPrimitive type) {
    return switch (type) {
      case INT, BOOLEAN -> new FieldShape.Whole(WORD, true);
      case BYTE, UBYTE, CHAR -> new FieldShape.Whole(BYTE, false);
      case FLOAT -> new FieldShape.Real(WORD);
      case DOUBLE -> new FieldShape.Real(LONG);
      case STRING, FORMAT -> new FieldShape.Text();
    };
  }

  /** Every field with its type and unit; structures within are indented. */
  static String text(IpcForm form) {
    StringBuilder text = new StringBuilder();
    lines(form.format(), form.fields(), "", text);
    return text.isEmpty() ? "# no fields\n" : text.toString();
  }

  private static void lines(IpcFormat format, List<FieldName> names, String indent, StringBuilder text) {
    List<IpcFormat> members = members(format);
    for (int i = 0; i < names.size(); i++) {
      FieldName name = names.get(i);
      text.append(indent).append(members.get(i)).append(' ').append(name.name())
          .append(name.unit().isEmpty() ? "" : " [" + name.unit() + "]").append('\n');
      inner(members.get(i), name, indent, text);
    }
  }

  private static void inner(IpcFormat format, FieldName name, String indent, StringBuilder text) {
    switch (format) {
      case IpcFormat.Struct struct -> lines(struct, name.members(), indent + "  ", text);
      case IpcFormat.VariableArray array -> inner(array.element(), name, indent, text);
      case IpcFormat.FixedArray array -> inner(array.element(), name, indent, text);
      default -> {}
    }
  }
}
