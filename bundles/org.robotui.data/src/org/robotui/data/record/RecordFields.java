package org.robotui.data.record;

import java.lang.reflect.RecordComponent;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.geometry.Quaternion;

/**
 * The fields of one Java record type, and those that users ask for although they are computed: the angles of a
 * rotation.
 */
final class RecordFields {
  private static final ClassValue<RecordFields> KNOWN = new ClassValue<>() {
    @Override
    protected RecordFields computeValue(Class<?> type) {
      return new RecordFields(type);
    }
  };
  private static final List<String> ANGLES = List.of("roll", "pitch", "yaw");

  private final Map<String, RecordField> fields = new LinkedHashMap<>();

  private RecordFields(Class<?> type) {
    for (RecordComponent component : type.getRecordComponents()) {
      fields.put(component.getName(), RecordField.of(component.getAccessor()));
    }
    if (type == Quaternion.class) {
      ANGLES.forEach(angle -> Arrays.stream(type.getMethods()).filter(m -> m.getName().equals(angle))
          .forEach(m -> fields.put(angle, RecordField.of(m))));
    }
  }

  /** Those of a type, looked up once. */
  static RecordFields of(Class<?> type) {
    return KNOWN.get(type);
  }

  List<String> names() {
    return List.copyOf(fields.keySet());
  }

  Optional<RecordField> find(String name) {
    return Optional.ofNullable(fields.get(name));
  }
}
