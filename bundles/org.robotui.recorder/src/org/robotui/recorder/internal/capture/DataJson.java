package org.robotui.recorder.internal.capture;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.RecordTree;
import org.robotui.recording.RecordedSchema;
import org.robotui.web.tree.JsonText;

/** Data of robots, and events, as JSON with a schema. Times are numbers of nanoseconds since 1970. */
public final class DataJson {
  /** What such messages are called. */
  public static final String ENCODING = "json";

  private static final int DEEPEST = 30;

  private DataJson() {}

  /** A record as JSON. */
  public static ByteBuffer bytes(DynamicRecord record) {
    return bytes(RecordTree.of(record));
  }

  /** Members of an object as JSON. */
  public static ByteBuffer bytes(Map<String, Object> members) {
    return ByteBuffer.wrap(JsonText.write(members).getBytes(StandardCharsets.UTF_8));
  }

  /** The schema of records of one type, by one of them. */
  public static RecordedSchema schema(String name, DynamicRecord example) {
    return schema(name, properties(example, 0));
  }

  /** A schema of the named properties. */
  public static RecordedSchema schema(String name, Map<String, Object> properties) {
    Map<String, Object> schema = new LinkedHashMap<>();
    schema.put("$schema", "https://json-schema.org/draft/2020-12/schema");
    schema.put("title", name);
    schema.put("type", "object");
    schema.put("properties", properties);
    return new RecordedSchema(name, "jsonschema", JsonText.write(schema).getBytes(StandardCharsets.UTF_8));
  }

  private static Map<String, Object> properties(DynamicRecord record, int depth) {
    Map<String, Object> properties = new LinkedHashMap<>();
    if (depth < DEEPEST) {
      record.fields().forEach(name -> record.field(name)
          .ifPresent(value -> properties.put(name, shape(value, depth + 1))));
    }
    return properties;
  }

  private static Map<String, Object> shape(FieldValue value, int depth) {
    return switch (value) {
      case FieldValue.Num number -> Map.of("type", List.of("number", "null"));
      case FieldValue.Flag flag -> Map.of("type", "boolean");
      case FieldValue.Text text -> Map.of("type", "string");
      case FieldValue.Time time -> Map.of("type", "integer");
      case FieldValue.Numbers numbers -> Map.of("type", "array", "items", Map.of("type", List.of("number", "null")));
      case FieldValue.Items items -> items.values().isEmpty() ? Map.of("type", "array")
          : Map.of("type", "array", "items", shape(items.values().getFirst(), depth));
      case FieldValue.Nested nested -> object(nested.value(), depth);
    };
  }

  private static Map<String, Object> object(DynamicRecord record, int depth) {
    Map<String, Object> shape = new LinkedHashMap<>();
    shape.put("type", "object");
    shape.put("properties", properties(record, depth));
    return shape;
  }
}
