package org.robotui.workbench.internal.rcp;

import org.eclipse.jface.action.MenuManager;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Menu;
import org.eclipse.ui.IWorkbenchWindow;
import org.eclipse.ui.menus.IMenuService;

/** A menu of the top bar: what all bundles contribute to it, fresh each time. */
final class PopupMenu {
  private final IWorkbenchWindow window;
  private final String id;

  PopupMenu(IWorkbenchWindow window, String id) {
    this.window = window;
    this.id = id;
  }

  void show(Control below) {
    MenuManager manager = new MenuManager(id, id);
    IMenuService service = window.getService(IMenuService.class);
    service.populateContributionManager(manager, "menu:" + id);
    Menu menu = manager.createContextMenu(below);
    menu.addListener(SWT.Hide, e -> below.getDisplay().asyncExec(() -> release(service, manager)));
    menu.setLocation(below.toDisplay(0, below.getSize().y));
    menu.setVisible(true);
  }

  /** After the event of the item that was chosen, which comes after the menu has gone. */
  private static void release(IMenuService service, MenuManager manager) {
    service.releaseContributions(manager);
    manager.dispose();
  }
}
