package org.robotui.rfic.gazebo.internal.scene;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;

/** Reads fields of a scene. What is missing is zero or empty, as Protocol Buffers leave that out. */
final class SceneFields {
  static final DynamicRecord NOTHING = new MapRecord("nothing", Map.of());

  private SceneFields() {}

  static List<DynamicRecord> each(DynamicRecord record, String name) {
    return record.field(name).filter(FieldValue.Items.class::isInstance).map(v -> ((FieldValue.Items) v).values())
        .orElse(List.of()).stream().filter(FieldValue.Nested.class::isInstance)
        .map(v -> ((FieldValue.Nested) v).value()).toList();
  }

  static Optional<DynamicRecord> inner(DynamicRecord record, String name) {
    return record.field(name).filter(FieldValue.Nested.class::isInstance).map(v -> ((FieldValue.Nested) v).value());
  }

  static String text(DynamicRecord record, String name) {
    return record.field(name).filter(FieldValue.Text.class::isInstance).map(v -> ((FieldValue.Text) v).value())
        .orElse("");
  }

  static boolean flag(DynamicRecord record, String name) {
    return record.field(name).filter(FieldValue.Flag.class::isInstance).map(v -> ((FieldValue.Flag) v).value())
        .orElse(false);
  }

  static double number(DynamicRecord record, String name) {
    return record.field(name).filter(FieldValue.Num.class::isInstance).map(v -> ((FieldValue.Num) v).value())
        .orElse(0.0);
  }

  static long whole(DynamicRecord record, String name) {
    return (long) number(record, name);
  }
}
