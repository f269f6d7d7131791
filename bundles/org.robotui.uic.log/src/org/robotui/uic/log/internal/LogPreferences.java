package org.robotui.uic.log.internal;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.robotui.api.config.Settings;
import org.robotui.api.config.SettingsStore;
import org.robotui.data.status.Severity;
import org.robotui.uic.log.internal.model.LogFilter;
import org.robotui.uic.log.internal.model.Search;

/** The filter as settings, so that it is kept. */
final class LogPreferences {
  private LogPreferences() {}

  static LogFilter read(Settings settings) {
    List<?> words = settings.list(LogType.LEVELS);
    Set<Severity> levels = EnumSet.noneOf(Severity.class);
    Arrays.stream(Severity.values()).filter(severity -> words.contains(LogType.word(severity))).forEach(levels::add);
    return new LogFilter(levels, texts(settings.list(LogType.ONLY_NODES)), texts(settings.list(LogType.HIDDEN_NODES)),
        Search.of(settings.text(LogType.SEARCH), settings.flag(LogType.EXPRESSION)), settings.flag(LogType.COLLAPSE));
  }

  /** Keeps what differs from what was kept before. */
  static void write(SettingsStore store, LogFilter filter) {
    Settings current = store.current();
    keep(store, current, LogType.LEVELS,
        Arrays.stream(Severity.values()).filter(filter.levels()::contains).map(LogType::word).toList());
    keep(store, current, LogType.ONLY_NODES, List.copyOf(new TreeSet<>(filter.only())));
    keep(store, current, LogType.HIDDEN_NODES, List.copyOf(new TreeSet<>(filter.hidden())));
    keep(store, current, LogType.SEARCH, filter.search().text());
    keep(store, current, LogType.EXPRESSION, filter.search().expression());
    keep(store, current, LogType.COLLAPSE, filter.collapse());
  }

  private static void keep(SettingsStore store, Settings current, String name, Object value) {
    if (!value.equals(current.values().get(name))) {
      store.set(name, value);
    }
  }

  private static Set<String> texts(List<?> values) {
    return values.stream().map(Object::toString).collect(Collectors.toSet());
  }
}
