package org.robotui.uic.graph.internal;

import org.robotui.api.config.Settings;
import org.robotui.api.config.SettingsStore;
import org.robotui.uic.graph.internal.model.Ask;

/** What is shown as settings, so that it is kept. Search, selection and what is open are of the day. */
final class GraphPreferences {
  private GraphPreferences() {}

  static Ask read(Settings settings) {
    return Ask.FIRST.show(settings.text(GraphOptions.SHOW).equals(GraphOptions.ALL), settings.flag(GraphOptions.DEBUG),
        settings.flag(GraphOptions.TF), settings.flag(GraphOptions.ENDS), settings.flag(GraphOptions.GROUPS));
  }

  static void write(SettingsStore store, Ask ask) {
    Settings current = store.current();
    keep(store, current, GraphOptions.SHOW, ask.topics() ? GraphOptions.ALL : GraphOptions.NODES);
    keep(store, current, GraphOptions.DEBUG, ask.tools());
    keep(store, current, GraphOptions.TF, ask.tf());
    keep(store, current, GraphOptions.ENDS, ask.ends());
    keep(store, current, GraphOptions.GROUPS, ask.groups());
  }

  private static void keep(SettingsStore store, Settings current, String name, Object value) {
    if (!value.equals(current.values().get(name))) {
      store.set(name, value);
    }
  }
}
