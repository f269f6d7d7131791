package org.robotui.data.record;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.robotui.data.Data;
import org.robotui.data.array.Bytes;

/**
 * A message of a type that no data type stands for, with the names that the robot gives. Implementations may decode
 * lazily; they are immutable and safe for use by several threads.
 */
public interface DynamicRecord extends Data {
  /**
   * The robot's name of the type, for example {@code turtlesim/Pose}.
   *
   * @return the type's name
   */
  String schema();

  /**
   * The names of the fields, in their order.
   *
   * @return the names
   */
  List<String> fields();

  /**
   * The value of one field of this record.
   *
   * @param name one of {@link #fields()}
   * @return the value, or none where there is no such field
   */
  Optional<FieldValue> field(String name);

  /**
   * The bytes of a field of many bytes, for who hands them on: without a number for each of them.
   *
   * @param name one of {@link #fields()}
   * @return the bytes, or none where the field holds something else or is not kept as bytes
   */
  default Optional<Bytes> bytes(String name) {
    return Optional.empty();
  }

  /**
   * The value at a path.
   *
   * @param path for example {@code pose.position.x} or {@code ranges[3]}
   * @return the value, or none where the path leads nowhere
   */
  default Optional<FieldValue> at(FieldPath path) {
    return path.in(this);
  }

  /**
   * The number at a path, for who reads one out of many values: without the text of its digits, and without what lies
   * beside it.
   *
   * @param path for example {@code pose.position.x} or {@code ranges[3]}
   * @return the number, or none where there is something else or nothing
   */
  default OptionalDouble number(FieldPath path) {
    return at(path).stream().filter(FieldValue.Num.class::isInstance).mapToDouble(v -> ((FieldValue.Num) v).value())
        .findFirst();
  }
}
