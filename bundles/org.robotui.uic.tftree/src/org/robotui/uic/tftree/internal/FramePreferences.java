package org.robotui.uic.tftree.internal;

import org.robotui.api.config.Settings;
import org.robotui.api.config.SettingsStore;
import org.robotui.data.FrameId;
import org.robotui.uic.tftree.internal.model.Ask;
import org.robotui.uic.tftree.internal.model.Ask.Reference;

/** What is shown as settings, so that it is kept. Search, selection and what is closed are of the day. */
final class FramePreferences {
  private static final String PARENT = "parent";

  private FramePreferences() {}

  static Ask read(Settings settings) {
    return Ask.FIRST.problems(settings.flag(TfTreeType.PROBLEMS))
        .drawn(settings.text(TfTreeType.FORM).equals(TfTreeType.DRAWN))
        .in(reference(settings.text(TfTreeType.REFERENCE)));
  }

  /** Keeps what differs from what was kept before. */
  static void write(SettingsStore store, Ask ask) {
    Settings current = store.current();
    keep(store, current, TfTreeType.PROBLEMS, ask.problems());
    keep(store, current, TfTreeType.FORM, ask.drawn() ? TfTreeType.DRAWN : TfTreeType.LIST);
    keep(store, current, TfTreeType.REFERENCE, words(ask.reference()));
  }

  private static Reference reference(String words) {
    int colon = words.indexOf(':');
    if (colon > 0 && !words.substring(0, colon).isBlank()) {
      return new Reference.Pinned(new FrameId(words.substring(0, colon), words.substring(colon + 1)));
    }
    return words.strip().equals(PARENT) ? new Reference.Parent() : new Reference.Root();
  }

  private static String words(Reference reference) {
    return switch (reference) {
      case Reference.Root r -> "";
      case Reference.Parent p -> PARENT;
      case Reference.Pinned pinned -> pinned.frame().toString();
    };
  }

  private static void keep(SettingsStore store, Settings current, String name, Object value) {
    if (!value.equals(current.values().get(name))) {
      store.set(name, value);
    }
  }
}
