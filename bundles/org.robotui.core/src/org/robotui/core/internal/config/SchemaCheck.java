package org.robotui.core.internal.config;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.host.Problem;
import org.robotui.core.internal.config.model.CheckedSettings;
import org.robotui.core.internal.config.model.CheckedValue;
import org.robotui.core.internal.config.model.RawSection;
import org.robotui.core.internal.config.model.SettingsCheck;

/** Checks what was written, or chosen by the user, against a schema. */
public final class SchemaCheck implements SettingsCheck {
  private static final Place CHOSEN = new Place("", 0, 0);

  @Override
  public CheckedSettings check(Schema schema, RawSection raw) {
    List<Problem> problems = new Mistakes();
    Settings settings = new ValueReader(problems).settings(((WrittenSection) raw).section(), schema);
    return problems.isEmpty() ? new CheckedSettings.Valid(settings) : new CheckedSettings.Invalid(problems);
  }

  @Override
  public CheckedValue value(Setting setting, Object value) {
    List<Problem> problems = new ArrayList<>();
    Optional<Object> read = new ValueReader(problems).read(yaml(value), setting.type(), setting.name());
    return read.filter(v -> problems.isEmpty())
        .<CheckedValue>map(CheckedValue.Fits::new)
        .orElseGet(() -> new CheckedValue.Wrong(problems.getFirst().message()));
  }

  @Override
  public RawSection nothing() {
    return new WrittenSection(new YamlValue.Section(List.of(), CHOSEN));
  }

  @Override
  public RawSection written(Map<String, Object> values) {
    return new WrittenSection((YamlValue.Section) yaml(values));
  }

  @Override
  public Map<String, Object> values(RawSection raw) {
    return section(((WrittenSection) raw).section());
  }

  private static Map<String, Object> section(YamlValue.Section section) {
    Map<String, Object> values = new LinkedHashMap<>();
    section.entries().forEach(e -> values.put(e.key(), plain(e.value())));
    return values;
  }

  private static Object plain(YamlValue value) {
    return switch (value) {
      case YamlValue.Scalar s -> scalar(s);
      case YamlValue.Items i -> i.items().stream().map(SchemaCheck::plain).toList();
      case YamlValue.Section s -> section(s);
    };
  }

  /** Written without quotes, {@code true} is no text; numbers stay texts, which all who take numbers read. */
  private static Object scalar(YamlValue.Scalar scalar) {
    return switch (scalar.plain() ? scalar.text() : "") {
      case "true", "yes", "on" -> true;
      case "false", "no", "off" -> false;
      default -> scalar.text();
    };
  }

  private static YamlValue yaml(Object value) {
    return switch (value) {
      case List<?> list -> new YamlValue.Items(list.stream().map(SchemaCheck::yaml).toList(), CHOSEN);
      case Map<?, ?> map -> new YamlValue.Section(map.entrySet().stream().map(SchemaCheck::entry).toList(), CHOSEN);
      case String text -> new YamlValue.Scalar(text, false, CHOSEN);
      default -> new YamlValue.Scalar(value.toString(), true, CHOSEN);
    };
  }

  private static YamlValue.Entry entry(Map.Entry<?, ?> entry) {
    return new YamlValue.Entry(entry.getKey().toString(), CHOSEN, yaml(entry.getValue()));
  }
}
