package org.robotui.uic.diagnostics.internal.view;

import java.util.List;
import java.util.function.Consumer;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.ui.Icon;
import org.robotui.ui.Theme;
import org.robotui.ui.control.PopupMenu;
import org.robotui.ui.control.QuietButton;
import org.robotui.uic.diagnostics.internal.model.Ask;

/** Chooses which source is shown, where there are several. Display thread. */
final class SourceButton {
  private final QuietButton button;
  private final Consumer<String> chosen;
  private List<String> sources = List.of();
  private String asked = "";

  SourceButton(Composite parent, Theme theme, Consumer<String> chosen) {
    this.chosen = chosen;
    button = new QuietButton(parent, theme, this::open).icon(Icon.LAYERS).hint("Choose whose reports are shown");
  }

  Control control() {
    return button;
  }

  void show(List<String> nextSources, String nextAsked) {
    sources = nextSources;
    asked = nextAsked;
    button.setEnabled(sources.size() > 1);
  }

  private void open() {
    PopupMenu menu = new PopupMenu(button);
    item(menu, "The aggregator, else all sources", "");
    item(menu, "All sources", Ask.ALL_SOURCES);
    sources.forEach(source -> item(menu, source, source));
    menu.open();
  }

  private void item(PopupMenu menu, String label, String source) {
    menu.radio(label, asked.equals(source), () -> chosen.accept(source));
  }
}
