package org.robotui.uic.diagnostics.internal;

import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.robotui.api.config.Settings;
import org.robotui.api.config.SettingsStore;
import org.robotui.uic.diagnostics.internal.model.Ask;

/** What is shown as settings, so that it is kept. Search, selection and moment are of the day. */
final class DiagnosticsPreferences {
  private static final int MOST_KEYS = 500;

  private DiagnosticsPreferences() {}

  static Ask read(Settings settings) {
    Ask ask =
        Ask.DEFAULT.source(settings.text(DiagnosticsType.SOURCE)).problems(settings.flag(DiagnosticsType.PROBLEMS));
    return new Ask(ask.source(), texts(settings.list(DiagnosticsType.OPENED)),
        texts(settings.list(DiagnosticsType.CLOSED)),
        ask.problems(), ask.search(), ask.selected(), ask.slot());
  }

  /** Keeps what differs from what was kept before. */
  static void write(SettingsStore store, Ask ask) {
    Settings current = store.current();
    keep(store, current, DiagnosticsType.SOURCE, ask.source());
    keep(store, current, DiagnosticsType.PROBLEMS, ask.problems());
    keep(store, current, DiagnosticsType.OPENED, list(ask.opened()));
    keep(store, current, DiagnosticsType.CLOSED, list(ask.closed()));
  }

  private static List<String> list(Set<String> keys) {
    return new TreeSet<>(keys).stream().limit(MOST_KEYS).toList();
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
