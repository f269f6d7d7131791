package org.robotui.data.record;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.RecordComponent;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.robotui.geometry.Quaternion;

/**
 * The fields of one Java record type, and those that users ask for although they are computed: the angles of a
 * rotation.
 */
final class RecordFields {
  private final Map<String, Function<Record, Optional<FieldValue>>> byName;
  private final Map<String, Method> accessors;
  private final List<String> names;

  private RecordFields(Map<String, Function<Record, Optional<FieldValue>>> byName, Map<String, Method> accessors) {
    this.byName = Map.copyOf(byName);
    this.accessors = Map.copyOf(accessors);
    this.names = List.copyOf(byName.keySet());
  }

  static RecordFields of(Class<?> type) {
    Map<String, Function<Record, Optional<FieldValue>>> fields = new LinkedHashMap<>();
    Map<String, Method> accessors = new LinkedHashMap<>();
    for (RecordComponent component : type.getRecordComponents()) {
      accessors.put(component.getName(), component.getAccessor());
      fields.put(component.getName(), record -> read(component, record));
    }
    if (type == Quaternion.class) {
      fields.put("roll", record -> PlainValue.of(((Quaternion) record).roll()));
      fields.put("pitch", record -> PlainValue.of(((Quaternion) record).pitch()));
      fields.put("yaw", record -> PlainValue.of(((Quaternion) record).yaw()));
    }
    return new RecordFields(fields, accessors);
  }

  private static Optional<FieldValue> read(RecordComponent component, Record record) {
    try {
      return PlainValue.of(component.getAccessor().invoke(record));
    } catch (IllegalAccessException | InvocationTargetException e) {
      return Optional.of(new FieldValue.Text("(" + component.getName() + " cannot be read: " + e.getMessage() + ")"));
    }
  }

  /** The value of a component as it is; none where it is computed, or cannot be read. */
  Optional<Object> raw(Record record, String name) {
    Method accessor = accessors.get(name);
    try {
      return accessor == null ? Optional.empty() : Optional.ofNullable(accessor.invoke(record));
    } catch (IllegalAccessException | InvocationTargetException e) {
      return Optional.empty(); // who asks for its field is told
    }
  }

  List<String> names() {
    return names;
  }

  Optional<FieldValue> value(Record record, String name) {
    return Optional.ofNullable(byName.get(name)).flatMap(f -> f.apply(record));
  }
}
