package org.robotui.ui.control;

import java.math.BigDecimal;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.stream.Collectors;
import java.util.stream.Stream;
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
    boolean several = takes(ValueType.ListOf.class)
        && (bare.contains(",") || alternatives().allMatch(ValueType.ListOf.class::isInstance));
    value = bare.isEmpty() ? Optional.empty()
        : Optional
            .of(several ? (Object) Arrays.stream(bare.split(",")).map(String::strip).filter(s -> !s.isEmpty()).toList()
                : plain(bare));
  }

  /** Where texts and others are possible, a truth value or a number is meant as such. */
  private Object plain(String bare) {
    boolean mixed = takes(ValueType.Text.class);
    if (mixed && takes(ValueType.Flag.class) && (bare.equals("true") || bare.equals("false"))) {
      return Boolean.valueOf(bare);
    }
    if (mixed && (takes(ValueType.Num.class) || takes(ValueType.Int.class))) {
      try {
        return new BigDecimal(bare);
      } catch (NumberFormatException e) {
        return bare;
      }
    }
    return bare;
  }

  /** What is wrong with it, as the end of a sentence that begins with its name. */
  Optional<String> problem() {
    if (value.isEmpty()) {
      return setting.required() ? Optional.of("'" + setting.name() + "' is needed: " + setting.help())
          : Optional.empty();
    }
    return check.apply(setting, value.get());
  }

  /** Words that can be chosen. */
  List<String> words() {
    return alternatives().filter(ValueType.Choice.class::isInstance).map(ValueType.Choice.class::cast)
        .flatMap(c -> c.words().stream()).distinct().toList();
  }

  /** Whether nothing else than these words is possible. */
  boolean isChoice() {
    return alternatives().allMatch(ValueType.Choice.class::isInstance);
  }

  boolean isFlag() {
    return alternatives().allMatch(ValueType.Flag.class::isInstance);
  }

  private boolean takes(Class<? extends ValueType> type) {
    return alternatives().anyMatch(type::isInstance);
  }

  private Stream<ValueType> alternatives() {
    return SettingShape.flat(setting.type());
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
