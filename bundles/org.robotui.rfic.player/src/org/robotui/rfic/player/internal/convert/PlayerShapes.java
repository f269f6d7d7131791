package org.robotui.rfic.player.internal.convert;

import java.util.List;
import java.util.Optional;
import org.robotui.data.record.FieldShape;
import org.robotui.data.record.RecordShape;
import org.robotui.player.layout.FieldLayout;
import org.robotui.player.layout.StructLayout;

/** The forms of Player's messages, and their descriptions with units. */
public final class PlayerShapes {
  private static final int BYTE = 8;
  private static final int SHORT = 16;
  private static final int WORD = 32;
  private static final int LONG = 64;

  private PlayerShapes() {}

  public static RecordShape of(Optional<StructLayout> struct) {
    return struct.map(PlayerShapes::of).orElseGet(() -> new RecordShape("empty", List.of(), List.of()));
  }

  private static RecordShape of(StructLayout struct) {
    return new RecordShape(struct.name(),
        struct.fields().stream().map(f -> new RecordShape.Field(f.name(), field(f))).toList(), List.of());
  }

  private static FieldShape field(FieldLayout field) {
    FieldShape one =
        field.struct().<FieldShape>map(s -> new FieldShape.Nested(of(s))).orElseGet(() -> primitive(field.type()));
    return field.isArray() ? new FieldShape.Many(one, field.size()) : one;
  }

  private static FieldShape primitive(String type) {
    return switch (type) {
      case "bool" -> new FieldShape.Flag();
      case "u8" -> new FieldShape.Whole(BYTE, false);
      case "i8" -> new FieldShape.Whole(BYTE, true);
      case "u16" -> new FieldShape.Whole(SHORT, false);
      case "i16" -> new FieldShape.Whole(SHORT, true);
      case "u32" -> new FieldShape.Whole(WORD, false);
      case "i32" -> new FieldShape.Whole(WORD, true);
      case "i64" -> new FieldShape.Whole(LONG, true);
      case "f32" -> new FieldShape.Real(WORD);
      case "f64" -> new FieldShape.Real(LONG);
      default -> new FieldShape.Text();
    };
  }

  /** Every field with its type, unit and meaning; structures within are indented. */
  public static String text(Optional<StructLayout> struct) {
    StringBuilder text = new StringBuilder();
    struct.ifPresent(s -> lines(s, "", text));
    return text.isEmpty() ? "# no fields\n" : text.toString();
  }

  private static void lines(StructLayout struct, String indent, StringBuilder text) {
    if (!struct.comment().isEmpty()) {
      text.append(indent).append("# ").append(struct.comment()).append('\n');
    }
    for (FieldLayout field : struct.fields()) {
      String array = !field.isArray() ? "" : field.size() > 0 ? "[" + field.size() + "]" : "[]";
      text.append(indent).append(field.type()).append(array).append(' ').append(field.name())
          .append(field.unit().isEmpty() ? "" : " [" + field.unit() + "]")
          .append(field.comment().isEmpty() ? "" : "  # " + field.comment()).append('\n');
      field.struct().ifPresent(inner -> lines(inner, indent + "  ", text));
    }
  }
}
