package org.robotui.data.record;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.data.array.Doubles;
import org.robotui.data.array.Floats;

/**
 * Any data type as a dynamic record: the fields are those of the Java record, in SI units, so that whatever shows
 * numbers can show all of them alike. Nothing is converted before it is asked for.
 */
public final class DataRecord implements DynamicRecord {
  private static final ClassValue<RecordFields> FIELDS = new ClassValue<>() {
    @Override
    protected RecordFields computeValue(Class<?> type) {
      return RecordFields.of(type);
    }
  };

  private final String schema;
  private final Record value;
  private final RecordFields fields;

  private DataRecord(Record value) {
    this.schema = value.getClass().getSimpleName();
    this.value = value;
    this.fields = FIELDS.get(value.getClass());
  }

  /**
   * Sees a value as a record.
   *
   * @param value any value; a dynamic record stands for itself
   * @return its fields; none for a type that is no Java record
   */
  public static DynamicRecord of(Data value) {
    return switch (value) {
      case DynamicRecord dynamic -> dynamic;
      case Record plain -> new DataRecord(plain);
      default -> new MapRecord(value.getClass().getSimpleName(), Map.of());
    };
  }

  /**
   * Sees a Java record that is no data type, such as the reply of a call, as a record with fields.
   *
   * @param value any record
   * @return its fields
   */
  public static DynamicRecord ofRecord(Record value) {
    return new DataRecord(value);
  }

  @Override
  public OptionalDouble number(FieldPath path) {
    Optional<Object> at = Optional.of(value);
    for (FieldPath.Step step : path.steps()) {
      at = at.isEmpty() ? at : follow(at.get(), step);
    }
    return at.isPresent() && at.get() instanceof Number number ? OptionalDouble.of(number.doubleValue())
        : DynamicRecord.super.number(path);
  }

  /** Nothing where the way by fields has to tell what is there. */
  private static Optional<Object> follow(Object at, FieldPath.Step step) {
    return switch (step) {
      case FieldPath.Step.Field field when at instanceof Record record && hasFields(record) -> FIELDS
          .get(record.getClass()).raw(record, field.name()).flatMap(DataRecord::present);
      case FieldPath.Step.Element element when at instanceof Doubles numbers
          && element.index() < numbers.size() -> Optional.of(numbers.get(element.index()));
      case FieldPath.Step.Element element when at instanceof Floats numbers
          && element.index() < numbers.size() -> Optional.of((double) numbers.get(element.index()));
      case FieldPath.Step.Element element when at instanceof List<?> list && element.index() < list.size() -> Optional
          .of(list.get(element.index()));
      default -> Optional.empty();
    };
  }

  private static boolean hasFields(Record record) {
    return !(record instanceof DynamicRecord || record instanceof Stamp || record instanceof FrameId);
  }

  private static Optional<Object> present(Object value) {
    return value instanceof Optional<?> optional ? optional.map(Object.class::cast) : Optional.of(value);
  }

  @Override
  public String schema() {
    return schema;
  }

  @Override
  public List<String> fields() {
    return fields.names();
  }

  @Override
  public Optional<FieldValue> field(String name) {
    return fields.value(value, name);
  }
}
