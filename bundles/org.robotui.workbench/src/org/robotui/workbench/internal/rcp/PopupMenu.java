package org.robotui.workbench.internal.rcp;

import java.util.List;
import java.util.stream.Stream;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Menu;
import org.eclipse.ui.IWorkbenchWindow;
import org.robotui.workbench.internal.keys.KeyWords;
import org.robotui.workbench.internal.model.SearchEntry;

/** A menu of the top bar: what all bundles contribute to it. */
final class PopupMenu {
  private final IWorkbenchWindow window;
  private final FilledMenus menus;
  private final String id;

  PopupMenu(IWorkbenchWindow window, String id) {
    this.window = window;
    menus = FilledMenus.of(window);
    this.id = id;
  }

  void show(Control below) {
    Menu menu = menu();
    menu.setLocation(below.toDisplay(0, below.getSize().y));
    menu.setVisible(true);
  }

  private Menu menu() {
    return menus.menu(id).createContextMenu(window.getShell());
  }

  /** What could be chosen now, for the search. */
  List<SearchEntry> entries(String group) {
    Menu menu = menu();
    menu.notifyListeners(SWT.Show, new Event());
    List<SearchEntry> entries = Stream.of(menu.getItems()).filter(item -> item.isEnabled() && !item.getText().isEmpty())
        .map(item -> entry(group, item.getText())).toList();
    menu.notifyListeners(SWT.Hide, new Event());
    return entries;
  }

  private SearchEntry entry(String group, String text) {
    String[] parts = text.split("\t", 2);
    return new SearchEntry(group, parts[0].replace("&", ""), parts.length > 1 ? keys(parts[1]) : "",
        () -> choose(text));
  }

  /** In the same order of modifiers as everywhere. */
  private static String keys(String text) {
    return KeyWords.read(text).map(KeyWords::text).orElse(text);
  }

  /** What is in the menu may have changed since. */
  private void choose(String text) {
    Menu menu = menu();
    menu.notifyListeners(SWT.Show, new Event());
    Stream.of(menu.getItems()).filter(item -> item.getText().equals(text) && item.isEnabled()).findFirst()
        .ifPresent(item -> item.notifyListeners(SWT.Selection, new Event()));
    if (!menu.isDisposed()) { // what was chosen may have closed the window
      menu.notifyListeners(SWT.Hide, new Event());
    }
  }
}
