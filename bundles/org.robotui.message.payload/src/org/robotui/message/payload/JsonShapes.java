package org.robotui.message.payload;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.data.record.FieldShape;
import org.robotui.data.record.RecordShape;
import org.robotui.web.tree.JsonText;
import org.robotui.web.tree.TreeException;
import org.robotui.web.tree.Trees;

/** The forms of records by JSON Schema, as far as forms for users need it: what it does not say is a text. */
final class JsonShapes {
  private static final int DEEPEST = 16;
  private static final int LONG = 64;

  private JsonShapes() {}

  static Optional<RecordShape> of(String type, String schema) {
    try {
      Map<String, Object> root = Trees.object(JsonText.read(schema));
      return root.containsKey("properties") ? Optional.of(record(type, root, 0)) : Optional.empty();
    } catch (TreeException e) {
      return Optional.empty();
    }
  }

  private static RecordShape record(String type, Map<String, Object> schema, int depth) throws TreeException {
    List<RecordShape.Field> fields = new ArrayList<>();
    if (schema.get("properties") instanceof Map<?, ?> properties && depth < DEEPEST) {
      for (Map.Entry<String, Object> each : Trees.object(properties).entrySet()) {
        fields.add(new RecordShape.Field(each.getKey(), field(each.getKey(), each.getValue(), depth)));
      }
    }
    return new RecordShape(type, fields, List.of());
  }

  private static FieldShape field(String name, Object value, int depth) throws TreeException {
    if (!(value instanceof Map<?, ?>)) {
      return new FieldShape.Text();
    }
    Map<String, Object> schema = Trees.object(value);
    return switch (Trees.optionalText(schema, "type").orElse("")) {
      case "object" -> new FieldShape.Nested(record(name, schema, depth + 1));
      case "array" -> new FieldShape.Many(depth < DEEPEST ? field(name, schema.get("items"), depth + 1)
          : new FieldShape.Text(), 0);
      case "number" -> new FieldShape.Real(LONG);
      case "integer" -> new FieldShape.Whole(LONG, true);
      case "boolean" -> new FieldShape.Flag();
      default -> new FieldShape.Text();
    };
  }
}
