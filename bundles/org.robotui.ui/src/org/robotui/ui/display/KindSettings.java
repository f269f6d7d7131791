package org.robotui.ui.display;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.config.Placed;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.ValueType;

/**
 * The settings of one of a list, checked against the schema of its kind, which core does not know. What is wrong falls
 * back and is said.
 *
 * @param settings checked, fallbacks included
 * @param problems sentences
 */
public record KindSettings(Settings settings, List<String> problems) {
  /**
   * Copies the list.
   *
   * @param settings checked
   * @param problems sentences
   */
  public KindSettings {
    problems = List.copyOf(problems);
  }

  /**
   * Checks what is written.
   *
   * @param schema of its kind
   * @param written by name
   * @return what holds, and what is wrong
   */
  public static KindSettings check(Schema schema, Map<String, Object> written) {
    Map<String, Object> values = new LinkedHashMap<>();
    List<String> problems = new ArrayList<>();
    for (Setting setting : schema.settings()) {
      Optional<Object> given = Optional.ofNullable(written.get(setting.name()));
      Optional<Object> taken = given.flatMap(setting.type()::fit);
      taken.or(setting::fallback).or(() -> least(setting)).ifPresent(v -> values.put(setting.name(), v));
      if (given.isPresent() && taken.isEmpty()) {
        problems.add(setting.name() + " is " + given.get() + ", must be " + setting.type().expected());
      }
    }
    written.keySet().stream().filter(name -> schema.find(name).isEmpty())
        .forEach(name -> problems.add("there is no setting '" + name + "'"));
    return new KindSettings(new Settings(schema, values), problems);
  }

  /** Something for a setting that must be written, so that a display that was just added works. */
  private static Optional<Object> least(Setting setting) {
    if (!setting.required()) {
      return Optional.empty();
    }
    return Optional.of(least(setting.type()));
  }

  private static Object least(ValueType type) {
    return switch (type) {
      case ValueType.Flag f -> false;
      case ValueType.Num n -> Math.clamp(0.0, n.min(), n.max());
      case ValueType.Int i -> Math.clamp(0L, i.min(), i.max());
      case ValueType.Choice c -> c.words().getFirst();
      case ValueType.ListOf l -> List.of();
      case ValueType.MapOf m -> Map.of();
      case ValueType.Section s -> check(s.schema(), Map.of()).settings();
      case ValueType.Text t -> "";
      case ValueType.AnyOf any -> "";
      case ValueType.Dependent d -> least(d.otherwise());
      case ValueType.WithPlace p -> Placed.nowhere(least(p.value()));
    };
  }
}
