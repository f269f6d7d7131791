package org.robotui.ui.control;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.stream.Collectors;
import org.robotui.api.config.Setting;
import org.robotui.api.config.ValueType;

/** What a user gives to one setting: words as typed, a truth value, or nothing, which leaves it to the component. */
final class SettingValue {
  private final Setting setting;
  private final BiFunction<Setting, Object, Optional<String>> check;
  private Optional<Object> value;

  SettingValue(Setting setting, Optional<Object> value, BiFunction<Setting, Object, Optional<String>> check) {
    this.setting = setting;
    this.value = value;
    this.check = check;
  }

  Setting setting() {
    return setting;
  }

  Optional<Object> value() {
    return value;
  }

  void set(Optional<Object> next) {
    value = next;
  }

  /** Takes what was typed: nothing for blanks, several for what commas part where several are possible. */
  void type(String words) {
    String bare = words.strip();
    boolean several = takesList() && (bare.contains(",") || setting.type() instanceof ValueType.ListOf);
    value = bare.isEmpty() ? Optional.empty()
        : Optional
            .of(several ? (Object) Arrays.stream(bare.split(",")).map(String::strip).filter(s -> !s.isEmpty()).toList()
                : bare);
  }

  /** What is wrong with it, as the end of a sentence that begins with its name. */
  Optional<String> problem() {
    if (value.isEmpty()) {
      return setting.required() ? Optional.of("'" + setting.name() + "' is needed: " + setting.help())
          : Optional.empty();
    }
    return check.apply(setting, value.get());
  }

  /** Groups and maps have no line of their own that could be typed. */
  boolean canBeTyped() {
    return switch (setting.type()) {
      case ValueType.Section s -> false;
      case ValueType.MapOf m -> false;
      case ValueType.ListOf l -> l.element() instanceof ValueType.Text;
      case ValueType.AnyOf a -> a.alternatives().stream().anyMatch(ValueType.Text.class::isInstance);
      default -> true;
    };
  }

  private boolean takesList() {
    return setting.type() instanceof ValueType.ListOf
        || setting.type() instanceof ValueType.AnyOf a
            && a.alternatives().stream().anyMatch(ValueType.ListOf.class::isInstance);
  }

  String text() {
    return value.map(SettingValue::text).orElse("");
  }

  /** What holds where nothing is given. */
  String fallback() {
    String usual = setting.fallback().map(SettingValue::text).filter(t -> !t.isEmpty()).orElse("");
    String unit =
        setting.type() instanceof ValueType.Num n && !n.unit().isEmpty() && !usual.isEmpty() ? " " + n.unit() : "";
    return usual.isEmpty() ? setting.required() ? "needed" : "none" : usual + unit;
  }

  private static String text(Object value) {
    return value instanceof List<?> list ? list.stream().map(Object::toString).collect(Collectors.joining(", "))
        : value.toString();
  }
}
