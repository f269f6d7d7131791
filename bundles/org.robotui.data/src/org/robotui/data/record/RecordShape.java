package org.robotui.data.record;

import java.util.List;
import java.util.Optional;

/**
 * The form of the records of one type, for those who build such records: forms, scripts, bridges.
 *
 * @param type the robot's name of the type, for example {@code geometry_msgs/Twist}
 * @param fields the fields in their order
 * @param constants values that the type gives names to
 */
public record RecordShape(String type, List<Field> fields, List<Constant> constants) {
  /**
   * A field of a record.
   *
   * @param name its name
   * @param shape what it holds
   */
  public record Field(String name, FieldShape shape) {}

  /**
   * A named value, often one that a field may take.
   *
   * @param name its name
   * @param value as written in the definition of the type
   */
  public record Constant(String name, String value) {}

  /**
   * Copies the lists.
   *
   * @param type the robot's name of the type
   * @param fields the fields
   * @param constants named values
   */
  public RecordShape {
    fields = List.copyOf(fields);
    constants = List.copyOf(constants);
  }

  /**
   * Finds a field.
   *
   * @param name its name
   * @return the field, or none
   */
  public Optional<Field> field(String name) {
    return fields.stream().filter(f -> f.name().equals(name)).findFirst();
  }
}
