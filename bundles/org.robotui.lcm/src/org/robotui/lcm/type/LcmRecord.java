package org.robotui.lcm.type;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/** A decoded struct. Immutable. */
public final class LcmRecord {

  private final Layout layout;
  private final LcmValue[] values;

  LcmRecord(Layout layout, LcmValue[] values) {
    this.layout = layout;
    this.values = values;
  }

  /**
   * The type.
   *
   * @return its full name
   */
  public String type() {
    return layout.type();
  }

  /**
   * The members.
   *
   * @return in the order of the declaration
   */
  public List<MemberDefinition> members() {
    return layout.definition().members();
  }

  /**
   * One member by its place.
   *
   * @param index from 0, in the order of {@link #members}
   * @return what it holds
   * @throws IndexOutOfBoundsException if there is no such member
   */
  public LcmValue value(int index) {
    return values[index];
  }

  /**
   * One member by its name.
   *
   * @param name its name
   * @return empty if there is no such member
   */
  public Optional<LcmValue> member(String name) {
    int index = layout.indexOf(name);
    return index < 0 ? Optional.empty() : Optional.of(values[index]);
  }

  /**
   * The value at a path.
   *
   * @param path such as {@code pose.position[2]}, {@code cells[3][7]} or {@code children[0].name}
   * @return empty if the path leads nowhere in this record
   */
  public Optional<LcmValue> at(String path) {
    return ValuePath.follow(this, path);
  }

  /**
   * The number at a path: truth values as 0 or 1.
   *
   * @param path as for {@link #at}
   * @return empty if there is nothing or no number
   */
  public OptionalDouble number(String path) {
    return switch (at(path).orElse(new LcmValue.Text(""))) {
      case LcmValue.Whole whole -> OptionalDouble.of(whole.value());
      case LcmValue.Real real -> OptionalDouble.of(real.value());
      case LcmValue.Flag flag -> OptionalDouble.of(flag.value() ? 1 : 0);
      default -> OptionalDouble.empty();
    };
  }

  /**
   * The array of numbers at a path.
   *
   * @param path as for {@link #at}
   * @return empty if there is nothing else or nothing
   */
  public Optional<NumberArray> numbers(String path) {
    return at(path).filter(LcmValue.Numbers.class::isInstance).map(value -> ((LcmValue.Numbers) value).value());
  }

  /**
   * The text at a path.
   *
   * @param path as for {@link #at}
   * @return empty if there is nothing or no text
   */
  public Optional<String> text(String path) {
    return at(path).filter(LcmValue.Text.class::isInstance).map(value -> ((LcmValue.Text) value).value());
  }

  Layout layout() {
    return layout;
  }

  /** Equal when the type's name and all values are. */
  @Override
  public boolean equals(Object other) {
    return other instanceof LcmRecord record && type().equals(record.type()) && Arrays.equals(values, record.values);
  }

  @Override
  public int hashCode() {
    return Arrays.hashCode(values);
  }

  @Override
  public String toString() {
    return type() + Arrays.toString(values);
  }
}
