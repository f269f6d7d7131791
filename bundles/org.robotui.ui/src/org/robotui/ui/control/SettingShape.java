package org.robotui.ui.control;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.robotui.api.config.Schema;
import org.robotui.api.config.ValueType;

/** The form in which a value can be edited: some types of values leave the choice. */
sealed interface SettingShape {
  /**
   * In one line.
   *
   * @param type what may be typed
   */
  record Line(ValueType type) implements SettingShape {}

  /**
   * A field for each setting.
   *
   * @param schema the settings
   */
  record Group(Schema schema) implements SettingShape {}

  /**
   * Items one below the other.
   *
   * @param element what each holds
   * @param named whether each has a name
   */
  record Many(ValueType element, boolean named) implements SettingShape {}

  /** Words for a menu. */
  default String words() {
    return switch (this) {
      case Line line -> "In One Line";
      case Group group -> "With a Field for Each Setting";
      case Many many -> many.named() ? "As Names with Values" : "As a List";
    };
  }

  /** All that a type may be written as; what fits into one line comes first. */
  static List<SettingShape> of(ValueType type) {
    List<ValueType> plain = flat(type).toList();
    List<ValueType> line = plain.stream().filter(SettingShape::fitsLine).toList();
    List<SettingShape> shapes = new ArrayList<>();
    if (!line.isEmpty()) {
      shapes.add(new Line(line.size() == plain.size() ? type : new ValueType.AnyOf(line)));
    }
    plain.forEach(t -> {
      switch (t) {
        case ValueType.Section s -> shapes.add(new Group(s.schema()));
        case ValueType.MapOf m -> shapes.add(new Many(m.value(), true));
        case ValueType.ListOf l -> shapes.add(new Many(l.element(), false));
        default -> {}
      }
    });
    return List.copyOf(shapes);
  }

  /** Those among which users choose: a list that fits into one line is typed there. */
  static List<SettingShape> offered(ValueType type) {
    return of(type).stream()
        .filter(s -> !(s instanceof Many m && !m.named() && fitsLine(new ValueType.ListOf(m.element())))).toList();
  }

  /** That which a value has; the first where it has none. */
  static SettingShape of(ValueType type, Object value) {
    List<SettingShape> shapes = of(type);
    return shapes.stream().filter(s -> s.holds(value)).findFirst().orElse(shapes.getFirst());
  }

  private boolean holds(Object value) {
    return switch (this) {
      case Line line -> !(value instanceof Map) && !(value instanceof List<?> list && list.stream()
          .anyMatch(v -> v instanceof Map || v instanceof List || v.toString().contains(",")));
      case Group group -> value instanceof Map;
      case Many many -> many.named() ? value instanceof Map : value instanceof List;
    };
  }

  private static boolean fitsLine(ValueType type) {
    return switch (type) {
      case ValueType.Section s -> false;
      case ValueType.MapOf m -> false;
      case ValueType.ListOf l -> flat(l.element()).allMatch(t -> !(t instanceof ValueType.Flag) && isPlain(t));
      default -> true;
    };
  }

  private static boolean isPlain(ValueType type) {
    return !(type instanceof ValueType.Section || type instanceof ValueType.MapOf || type instanceof ValueType.ListOf);
  }

  /** The alternatives, without their places. */
  static Stream<ValueType> flat(ValueType type) {
    return switch (type) {
      case ValueType.AnyOf any -> any.alternatives().stream().flatMap(SettingShape::flat);
      case ValueType.Dependent dependent -> flat(dependent.otherwise());
      case ValueType.WithPlace placed -> flat(placed.value());
      default -> Stream.of(type);
    };
  }
}
