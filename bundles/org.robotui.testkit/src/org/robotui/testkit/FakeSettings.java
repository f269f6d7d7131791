package org.robotui.testkit;

import java.util.LinkedHashMap;
import java.util.Map;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.SettingsStore;

/** Settings in memory: those of a schema, changed by what is set. Values are not checked. */
public final class FakeSettings implements SettingsStore {
  private final Schema schema;
  private final Map<String, Object> values = new LinkedHashMap<>();

  /**
   * Begins with the fallbacks.
   *
   * @param schema what there is
   */
  public FakeSettings(Schema schema) {
    this.schema = schema;
    schema.settings().forEach(this::fallback);
  }

  @Override
  public synchronized Settings current() {
    return new Settings(schema, values);
  }

  @Override
  public synchronized void set(String name, Object value) {
    if (schema.find(name).isEmpty()) {
      throw new IllegalArgumentException("no setting '" + name + "' in the schema");
    }
    values.put(name, value);
  }

  private void fallback(Setting setting) {
    setting.fallback().ifPresent(value -> values.put(setting.name(), value));
  }
}
