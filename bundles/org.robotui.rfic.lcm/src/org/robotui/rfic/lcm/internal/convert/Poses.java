package org.robotui.rfic.lcm.internal.convert;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.rfic.lcm.internal.language.Field;
import org.robotui.rfic.lcm.internal.language.Quantity;
import org.robotui.rfic.lcm.internal.language.Values;

/** Places and rotations, however a message says them, once or many times. */
final class Poses {
  private static final String POSITION = "position";
  private static final String ORIENTATION = "orientation";

  private Poses() {}

  /** The fields of one pose. */
  static Stream<Field> fields() {
    return Stream.of(
        Field.numbers(POSITION, Quantity.LENGTH, "position", "pos", "pose.position", "translation"),
        Field.numbers("x", Quantity.LENGTH, "x").in(POSITION), Field.numbers("y", Quantity.LENGTH, "y").in(POSITION),
        Field.numbers("z", Quantity.LENGTH, "z").in(POSITION),
        Field.numbers(ORIENTATION, Quantity.ROTATION, "orientation", "pose.orientation", "rotation", "quat"),
        Field.numbers("roll", Quantity.ANGLE, "roll").in(ORIENTATION),
        Field.numbers("pitch", Quantity.ANGLE, "pitch").in(ORIENTATION),
        Field.numbers("yaw", Quantity.ANGLE, "yaw", "heading", "theta").in(ORIENTATION));
  }

  /** The fields of poses in an array. */
  static Stream<Field> fields(String... arrays) {
    return fields().map(f -> new Field(f.name(), f.kind(), f.quantity(), f.group(),
        Stream.of(arrays).flatMap(a -> f.assumed().stream().map(m -> a + "[]." + m)).toList()));
  }

  static RigidTransform one(Values values) {
    return all(values, 1).getFirst();
  }

  /** How many there are. */
  static int count(Values values) {
    return values.has("x") ? values.numbers("x").length : values.rows(POSITION);
  }

  static List<RigidTransform> all(Values values, int count) {
    Rows position = Rows.of(values, POSITION, count);
    Rows orientation = Rows.of(values, ORIENTATION, count);
    boolean scalarFirst = !values.unit(ORIENTATION).equals("xyzw");
    Axes axes = new Axes(column(values, "x", count), column(values, "y", count), column(values, "z", count));
    Axes angles = new Axes(column(values, "roll", count), column(values, "pitch", count), column(values, "yaw", count));
    List<RigidTransform> poses = new ArrayList<>(count);
    for (int i = 0; i < count; i++) {
      Vector3 at = vector(position, axes, i);
      poses.add(new RigidTransform(at, orientation.width() == 0
          ? Quaternion.fromRollPitchYaw(angles.x(i), angles.y(i), angles.z(i))
          : rotation(orientation, i, scalarFirst)));
    }
    return poses;
  }

  /** Three numbers, by one field or by three. */
  static Vector3 vector(Values values, String all, String x, String y, String z) {
    return vector(Rows.of(values, all, 1), new Axes(column(values, x, 1), column(values, y, 1), column(values, z, 1)),
        0);
  }

  private static Vector3 vector(Rows rows, Axes axes, int i) {
    Vector3 vector = new Vector3(axes.given(0) ? axes.x(i) : rows.at(i, 0), axes.given(1) ? axes.y(i) : rows.at(i, 1),
        axes.given(2) ? axes.z(i) : rows.at(i, 2));
    if (!vector.isFinite()) {
      throw new IllegalArgumentException("a place or velocity must be finite, is " + vector);
    }
    return vector;
  }

  /** All zeros are sent for "none", and read as no rotation. */
  static Quaternion rotation(Rows rows, int i, boolean scalarFirst) {
    if (rows.width() != 4) {
      throw new IllegalArgumentException("an orientation has 4 numbers, not " + rows.width());
    }
    int first = scalarFirst ? 1 : 0;
    double w = rows.at(i, scalarFirst ? 0 : 3);
    Quaternion q = new Quaternion(rows.at(i, first), rows.at(i, first + 1), rows.at(i, first + 2), w);
    if (q.x() == 0 && q.y() == 0 && q.z() == 0 && w == 0) {
      return Quaternion.IDENTITY;
    }
    try {
      return q.normalized();
    } catch (ArithmeticException e) {
      throw new IllegalArgumentException("orientation: " + e.getMessage(), e);
    }
  }

  private static double[] column(Values values, String field, int count) {
    double[] column = values.numbers(field);
    if (values.has(field) && column.length != count && column.length != 1) {
      throw new IllegalArgumentException(field + " has " + column.length + " numbers for " + count + " places");
    }
    return column;
  }

  /** Three columns of numbers, each of which may be missing or stand for all. */
  private record Axes(double[] xs, double[] ys, double[] zs) {
    boolean given(int axis) {
      return (axis == 0 ? xs : axis == 1 ? ys : zs).length > 0;
    }

    double x(int i) {
      return at(xs, i);
    }

    double y(int i) {
      return at(ys, i);
    }

    double z(int i) {
      return at(zs, i);
    }

    private static double at(double[] column, int i) {
      return column.length == 0 ? 0 : column[column.length == 1 ? 0 : i];
    }
  }

  /** Rows of numbers. */
  record Rows(double[] numbers, int width) {
    static Rows of(Values values, String field, int count) {
      double[] numbers = values.numbers(field);
      if (count > 0 && numbers.length % count != 0) {
        throw new IllegalArgumentException(
            field + " has " + numbers.length + " numbers, which are not as many for each of " + count);
      }
      return new Rows(numbers, count == 0 ? 0 : numbers.length / count);
    }

    double at(int row, int column) {
      return column < width ? numbers[row * width + column] : 0;
    }
  }
}
