package org.robotui.workbench.internal.display;

import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Listener;
import org.robotui.api.host.Host;

/** Tells core that the display thread lives and whether the user looks at one of our windows. Display thread only. */
public final class Heartbeat implements AutoCloseable {
  private static final int PERIOD_MILLIS = 40;

  private final Host host;
  private final Display display;
  private final Runnable beat = this::beat;
  private final Listener activation = e -> later();
  private boolean focused;
  private boolean begun;
  private boolean closed;

  /** Makes a heart that does not beat yet. */
  public Heartbeat(Host host, Display display) {
    this.host = host;
    this.display = display;
    display.addFilter(SWT.Activate, activation);
    display.addFilter(SWT.Deactivate, activation);
  }

  /** Starts beating, once: not before the window stands, for making it is long and holds nothing up that moves. */
  public void begin() {
    if (!begun) {
      begun = true;
      beat();
    }
  }

  @Override
  public void close() {
    closed = true;
    if (!display.isDisposed()) {
      display.removeFilter(SWT.Activate, activation);
      display.removeFilter(SWT.Deactivate, activation);
    }
  }

  private void beat() {
    if (!closed && !display.isDisposed()) {
      host.displayAlive();
      display.timerExec(PERIOD_MILLIS, beat);
    }
  }

  /** Between two of our windows the focus is nowhere for a moment: look when the change is complete. */
  private void later() {
    display.asyncExec(this::look);
  }

  private void look() {
    if (!closed && !display.isDisposed()) {
      boolean now = display.getActiveShell() != null;
      if (now != focused) {
        focused = now;
        host.displayFocused(now);
      }
    }
  }
}
