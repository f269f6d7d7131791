package org.robotui.ros2.parameter;

import java.util.Objects;
import java.util.Optional;

/**
 * What a parameter is and may be.
 *
 * @param name its name
 * @param type the number of the type of its value, see {@link Ros2ParameterValue#type}
 * @param description for a user to read; may be empty
 * @param constraints what else it must be, for a user to read; may be empty
 * @param readOnly whether it cannot be set
 * @param dynamicTyping whether its type may change
 * @param doubles what a real number may be
 * @param integers what a whole number may be
 */
public record Ros2ParameterDescriptor(String name, int type, String description, String constraints, boolean readOnly,
    boolean dynamicTyping, Optional<DoubleRange> doubles, Optional<IntegerRange> integers) {

  /**
   * What a real number may be.
   *
   * @param from the least
   * @param to the most
   * @param step between two, counted from the least; 0 for any. The most is always fine
   */
  public record DoubleRange(double from, double to, double step) {}

  /**
   * What a whole number may be.
   *
   * @param from the least
   * @param to the most
   * @param step between two, counted from the least; 0 for any. The most is always fine
   */
  public record IntegerRange(long from, long to, long step) {}

  /** Checks that nothing is missing. */
  public Ros2ParameterDescriptor {
    Objects.requireNonNull(name, "name");
    Objects.requireNonNull(description, "description");
    Objects.requireNonNull(constraints, "constraints");
    Objects.requireNonNull(doubles, "doubles");
    Objects.requireNonNull(integers, "integers");
  }

  /**
   * Of a parameter that may be anything of its type.
   *
   * @param name its name
   * @param value one of the type
   * @param description for a user to read
   * @return the descriptor
   */
  public static Ros2ParameterDescriptor of(String name, Ros2ParameterValue value, String description) {
    return new Ros2ParameterDescriptor(name, value.type(), description, "", false, false, Optional.empty(),
        Optional.empty());
  }

  /**
   * The same within a range.
   *
   * @param range what the number may be
   * @return the changed descriptor
   */
  public Ros2ParameterDescriptor within(DoubleRange range) {
    return new Ros2ParameterDescriptor(name, type, description, constraints, readOnly, dynamicTyping,
        Optional.of(range), integers);
  }

  /**
   * The same within a range.
   *
   * @param range what the number may be
   * @return the changed descriptor
   */
  public Ros2ParameterDescriptor within(IntegerRange range) {
    return new Ros2ParameterDescriptor(name, type, description, constraints, readOnly, dynamicTyping, doubles,
        Optional.of(range));
  }

  /**
   * Why a value is none for this parameter.
   *
   * @param value the value
   * @return empty if it may have it; the sentence is for a user to read
   */
  public Optional<String> fault(Ros2ParameterValue value) {
    if (readOnly) {
      return Optional.of("parameter '" + name + "' is read-only");
    }
    if (!dynamicTyping && value.type() != type) {
      return Optional.of("parameter '" + name + "' has type " + type + ", not " + value.type());
    }
    return switch (value) {
      case Ros2ParameterValue.OfDouble real -> doubles.filter(range -> !fits(real.value(), range))
          .map(range -> outside(real.value(), range.from(), range.to()));
      case Ros2ParameterValue.OfInteger whole -> integers.filter(range -> !fits(whole.value(), range))
          .map(range -> outside(whole.value(), range.from(), range.to()));
      default -> Optional.empty();
    };
  }

  private String outside(Object value, Object from, Object to) {
    return "parameter '" + name + "' is from " + from + " to " + to + " in its steps, which " + value + " is not";
  }

  private static boolean fits(double value, DoubleRange range) {
    if (!(value >= range.from() && value <= range.to())) {
      return false;
    }
    double steps = (value - range.from()) / range.step();
    return range.step() == 0 || value == range.to() || Math.abs(steps - Math.rint(steps)) < 1e-9 * Math.max(1, steps);
  }

  private static boolean fits(long value, IntegerRange range) {
    boolean inside = value >= range.from() && value <= range.to();
    return inside
        && (range.step() == 0 || value == range.to()
            || Long.remainderUnsigned(value - range.from(), range.step()) == 0);
  }
}
