package org.robotui.workbench.internal.rcp;

import java.util.List;
import java.util.stream.Stream;
import org.eclipse.jface.action.MenuManager;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Menu;
import org.eclipse.ui.IWorkbenchWindow;
import org.robotui.workbench.internal.keys.KeyWords;
import org.robotui.workbench.internal.model.SearchEntry;

/** A menu of the top bar: what all bundles contribute to it, fresh each time. */
final class PopupMenu {
  private final IWorkbenchWindow window;
  private final FilledMenus menus;
  private final String id;

  PopupMenu(IWorkbenchWindow window, String id) {
    this.window = window;
    menus = new FilledMenus(window);
    this.id = id;
  }

  void show(Control below) {
    MenuManager manager = menus.fill(id);
    Menu menu = manager.createContextMenu(below);
    // After the event of the item that was chosen, which comes after the menu has gone.
    menu.addListener(SWT.Hide, e -> below.getDisplay().asyncExec(() -> menus.release(manager)));
    menu.setLocation(below.toDisplay(0, below.getSize().y));
    menu.setVisible(true);
  }

  /** What could be chosen now, for the search. */
  List<SearchEntry> entries(String group) {
    MenuManager manager = menus.fill(id);
    Menu menu = manager.createContextMenu(window.getShell());
    menu.notifyListeners(SWT.Show, new Event());
    List<SearchEntry> entries = Stream.of(menu.getItems()).filter(item -> item.isEnabled() && !item.getText().isEmpty())
        .map(item -> entry(group, item.getText())).toList();
    menu.notifyListeners(SWT.Hide, new Event());
    menus.release(manager);
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

  /** The menu is made anew: what is in it may have changed since. */
  private void choose(String text) {
    MenuManager manager = menus.fill(id);
    Menu menu = manager.createContextMenu(window.getShell());
    menu.notifyListeners(SWT.Show, new Event());
    Stream.of(menu.getItems()).filter(item -> item.getText().equals(text) && item.isEnabled()).findFirst()
        .ifPresent(item -> item.notifyListeners(SWT.Selection, new Event()));
    menus.release(manager);
  }
}
