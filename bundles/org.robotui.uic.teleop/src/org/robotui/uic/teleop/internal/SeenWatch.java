package org.robotui.uic.teleop.internal;

import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Shell;

/**
 * Tells again and again that a view is seen by whoever is at the window: it is not behind another tab, and the window
 * in front is its own, or belongs to it. Display thread.
 */
final class SeenWatch {
  private static final int MILLIS = 100;

  private final Control view;
  private final Runnable seen;

  SeenWatch(Control view, Runnable seen) {
    this.view = view;
    this.seen = seen;
  }

  void begin() {
    if (!view.isDisposed()) {
      Display display = view.getDisplay();
      if (view.isVisible() && main(view.getShell()) == main(display.getActiveShell())) {
        seen.run();
      }
      display.timerExec(MILLIS, this::begin);
    }
  }

  private static Shell main(Shell shell) {
    return shell != null && shell.getParent() instanceof Shell parent ? main(parent) : shell;
  }
}
