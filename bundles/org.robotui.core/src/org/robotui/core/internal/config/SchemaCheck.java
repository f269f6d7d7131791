package org.robotui.core.internal.config;

import java.util.ArrayList;
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
    List<Problem> problems = new ArrayList<>();
    Settings settings = new ValueReader(problems).settings(((WrittenSection) raw).section(), schema);
    return problems.isEmpty() ? new CheckedSettings.Valid(settings) : new CheckedSettings.Invalid(problems);
  }

  @Override
  public CheckedValue value(Setting setting, Object value) {
    List<Problem> problems = new ArrayList<>();
    Optional<Object> read = new ValueReader(problems).read(written(value), setting.type(), setting.name());
    return read.filter(v -> problems.isEmpty())
        .<CheckedValue>map(CheckedValue.Fits::new)
        .orElseGet(() -> new CheckedValue.Wrong(problems.getFirst().message()));
  }

  @Override
  public RawSection nothing() {
    return new WrittenSection(new YamlValue.Section(List.of(), CHOSEN));
  }

  private static YamlValue written(Object value) {
    return switch (value) {
      case List<?> list -> new YamlValue.Items(list.stream().map(SchemaCheck::written).toList(), CHOSEN);
      case Map<?, ?> map -> new YamlValue.Section(map.entrySet().stream().map(SchemaCheck::entry).toList(), CHOSEN);
      case String text -> new YamlValue.Scalar(text, false, CHOSEN);
      default -> new YamlValue.Scalar(value.toString(), true, CHOSEN);
    };
  }

  private static YamlValue.Entry entry(Map.Entry<?, ?> entry) {
    return new YamlValue.Entry(entry.getKey().toString(), CHOSEN, written(entry.getValue()));
  }
}
