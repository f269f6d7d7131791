package org.robotui.core.internal.life;

import java.util.HashMap;
import java.util.Map;
import java.util.function.BiConsumer;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.SettingsStore;
import org.robotui.core.internal.config.model.CheckedValue;
import org.robotui.core.internal.config.model.SettingsCheck;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The settings of one view: what is written, changed by what the user chose. */
final class UicSettings implements SettingsStore {
  private static final Logger LOG = LoggerFactory.getLogger(UicSettings.class);

  private final SettingsCheck check;
  private final BiConsumer<String, Object> keep;
  private volatile Settings current;

  /**
   * Settings in force.
   *
   * @param written as checked
   * @param chosen by the user; what does not fit any more is left out
   * @param check checks single values
   * @param keep is given what the user changes
   */
  UicSettings(Settings written, Map<String, Object> chosen, SettingsCheck check, BiConsumer<String, Object> keep) {
    this.check = check;
    this.keep = keep;
    this.current = written;
    chosen.forEach(this::adopt);
  }

  private void adopt(String name, Object value) {
    try {
      current = with(name, checked(name, value));
    } catch (IllegalArgumentException e) {
      LOG.info("A setting chosen earlier does not fit any more: {}", e.getMessage());
    }
  }

  @Override
  public Settings current() {
    return current;
  }

  @Override
  public synchronized void set(String name, Object value) {
    current = with(name, checked(name, value));
    keep.accept(name, value);
  }

  private Settings with(String name, Object value) {
    Map<String, Object> values = new HashMap<>(current.values());
    values.put(name, value);
    return new Settings(current.schema(), values);
  }

  private Object checked(String name, Object value) {
    Schema schema = current.schema();
    Setting setting = schema.find(name)
        .orElseThrow(() -> new IllegalArgumentException("no setting '" + name + "'"));
    return switch (check.value(setting, value)) {
      case CheckedValue.Fits fits -> fits.value();
      case CheckedValue.Wrong wrong -> throw new IllegalArgumentException("'" + name + "': " + wrong.message());
    };
  }
}
