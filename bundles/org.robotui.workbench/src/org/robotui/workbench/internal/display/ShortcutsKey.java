package org.robotui.workbench.internal.display;

import org.eclipse.swt.SWT;
import org.eclipse.swt.custom.CCombo;
import org.eclipse.swt.custom.StyledText;
import org.eclipse.swt.widgets.Combo;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Listener;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.swt.widgets.Spinner;
import org.eclipse.swt.widgets.Text;
import org.robotui.workbench.internal.dock.ViewWindow;

/**
 * The question mark, which opens the list of shortcuts wherever it is not text. It is no key binding of the platform:
 * those take the key from text fields as well. Display thread only.
 */
public final class ShortcutsKey {
  private final Composite views;
  private final Runnable open;

  private ShortcutsKey(Composite views, Runnable open) {
    this.views = views;
    this.open = open;
  }

  /**
   * Listens until the composite is disposed.
   *
   * @param views in which the key opens the list
   * @param open opens it
   */
  public static void listen(Composite views, Runnable open) {
    Listener filter = new ShortcutsKey(views, open)::key;
    views.getDisplay().addFilter(SWT.KeyDown, filter);
    views.addListener(SWT.Dispose, e -> views.getDisplay().removeFilter(SWT.KeyDown, filter));
  }

  private void key(Event event) {
    boolean chord = (event.stateMask & (SWT.CTRL | SWT.ALT | SWT.COMMAND)) != 0;
    if (event.character == '?' && !chord && event.widget instanceof Control control && !takesText(control)
        && isWithin(control)) {
      event.doit = false;
      open.run();
    }
  }

  private static boolean takesText(Control control) {
    return switch (control) {
      case Text t -> true;
      case StyledText t -> true;
      case Combo c -> true;
      case CCombo c -> true;
      case Spinner s -> true;
      default -> false;
    };
  }

  private boolean isWithin(Control control) {
    for (Control at = control; at != null; at = at.getParent()) {
      if (at == views || at instanceof Shell shell && ViewWindow.isOne(shell) && at.getParent() == views.getShell()) {
        return true;
      }
    }
    return false;
  }
}
