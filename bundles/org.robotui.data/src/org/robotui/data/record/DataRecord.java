package org.robotui.data.record;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.robotui.data.Data;

/**
 * Any data type as a dynamic record: the fields are those of the Java record, in SI units, so that whatever shows
 * numbers can show all of them alike. Nothing is converted before it is asked for.
 */
public final class DataRecord implements DynamicRecord {
  private final String schema;
  private final Record value;
  private final RecordFields fields;

  private DataRecord(Record value) {
    this.schema = value.getClass().getSimpleName();
    this.value = value;
    this.fields = RecordFields.of(value.getClass());
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

  Record value() {
    return value;
  }

  @Override
  public OptionalDouble number(FieldPath path) {
    return new NumberPath(path).in(this);
  }

  /** By the values of fields, which have to tell what is there where Java records do not. */
  OptionalDouble numberOfFields(FieldPath path) {
    return DynamicRecord.super.number(path);
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
    return fields.find(name).flatMap(f -> f.value(value));
  }
}
