package org.robotui.workbench.internal.rcp;

import java.util.Arrays;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.swt.widgets.Widget;
import org.eclipse.ui.IWorkbench;
import org.eclipse.ui.contexts.IContextService;
import org.robotui.workbench.internal.dock.ViewWindow;

/**
 * Has keys run commands in windows of views as they do in main windows. The platform takes every window that it has not
 * made for a dialog, in which only few keys hold. Display thread only.
 */
final class ViewWindowKeys {
  private final IContextService contexts;

  private ViewWindowKeys(IContextService contexts) {
    this.contexts = contexts;
  }

  static void follow(IWorkbench workbench) {
    ViewWindowKeys keys = new ViewWindowKeys(workbench.getService(IContextService.class));
    Display display = workbench.getDisplay();
    Arrays.stream(display.getShells()).forEach(keys::register);
    display.addFilter(SWT.Show, event -> keys.register(event.widget));
  }

  /** Ends with the window. */
  private void register(Widget shown) {
    if (shown instanceof Shell shell && ViewWindow.isOne(shell)) {
      contexts.registerShell(shell, IContextService.TYPE_WINDOW);
    }
  }
}
