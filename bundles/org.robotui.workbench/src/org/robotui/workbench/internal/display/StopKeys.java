package org.robotui.workbench.internal.display;

import org.eclipse.swt.SWT;
import org.eclipse.swt.custom.CCombo;
import org.eclipse.swt.custom.StyledText;
import org.eclipse.swt.widgets.Button;
import org.eclipse.swt.widgets.Combo;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Listener;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.swt.widgets.Spinner;
import org.eclipse.swt.widgets.Text;
import org.robotui.ui.SpaceKey;
import org.robotui.ui.control.QuietButton;
import org.robotui.workbench.internal.dock.RuicSurface;
import org.robotui.workbench.internal.dock.ViewWindow;

/**
 * The keys that stop: F12 everywhere, also in dialogs, and space in the views of a robot. They are seen before any
 * widget or key binding, so that nothing can take them away. Display thread only.
 */
public final class StopKeys implements AutoCloseable {
  private final Display display;
  private final Runnable stop;
  private final Listener filter = this::key;

  /** Listens from now on. */
  public StopKeys(Display display, Runnable stop) {
    this.display = display;
    this.stop = stop;
    display.addFilter(SWT.KeyDown, filter);
  }

  @Override
  public void close() {
    if (!display.isDisposed()) {
      display.removeFilter(SWT.KeyDown, filter);
    }
  }

  private void key(Event event) {
    boolean everywhere = event.keyCode == SWT.F12 && event.stateMask == 0;
    if (everywhere || event.keyCode == ' ' && event.stateMask == 0 && stopsBySpace(event.widget)) {
      stop.run();
      event.doit = !everywhere;
    }
  }

  private static boolean stopsBySpace(Object widget) {
    return widget instanceof Control control && !takesSpace(control) && isInSurface(control);
  }

  private static boolean takesSpace(Control control) {
    return switch (control) {
      case Text t -> true;
      case StyledText t -> true;
      case Combo c -> true;
      case CCombo c -> true;
      case Spinner s -> true;
      case Button b -> true;
      case QuietButton b -> true;
      default -> SpaceKey.isClaimed(control);
    };
  }

  private static boolean isInSurface(Control control) {
    for (Composite above = control.getParent(); above != null; above = above.getParent()) {
      if (above instanceof RuicSurface || above instanceof Shell shell && ViewWindow.isOne(shell)) {
        return true;
      }
    }
    return false;
  }
}
