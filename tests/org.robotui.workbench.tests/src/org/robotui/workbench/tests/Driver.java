package org.robotui.workbench.tests;

import static org.junit.jupiter.api.Assertions.fail;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Event;
import org.eclipse.ui.IWorkbenchWindow;

/** What the tests of the window do with it: wait while its loop goes on, find widgets, press. Display thread. */
final class Driver {
  private static final int LOOK_MILLIS = 20;

  private Driver() {}

  /**
   * Runs the loop of the display until something holds; fails when it never does.
   *
   * @param patience how long to wait
   * @param condition what to wait for; asked on the display thread
   * @param what what was waited for, for the failure
   */
  static void until(Duration patience, BooleanSupplier condition, Supplier<String> what) {
    Display display = Display.getCurrent();
    Runnable awake = waking(display);
    display.timerExec(LOOK_MILLIS, awake);
    long end = System.nanoTime() + patience.toNanos();
    try {
      while (!condition.getAsBoolean()) {
        if (System.nanoTime() > end) {
          fail("waited in vain: " + what.get());
        }
        pump(display);
      }
    } finally {
      display.timerExec(-1, awake);
    }
  }

  /** The widgets of a window whose class has a simple name. */
  static List<Control> widgets(IWorkbenchWindow in, String type) {
    List<Control> found = new ArrayList<>();
    collect(in.getShell(), type, found);
    return found;
  }

  /** Presses the first row of the navigator if there is one already: it comes a moment after the robot. */
  static void pressFirstRobot(IWorkbenchWindow in) {
    Event event = new Event();
    event.button = 1;
    event.y = 10;
    widgets(in, "RobotList").stream().filter(l -> l.getSize().y > 0).findFirst()
        .ifPresent(l -> l.notifyListeners(SWT.MouseDown, event));
  }

  private static void collect(Composite above, String type, List<Control> found) {
    for (Control child : above.getChildren()) {
      if (child.getClass().getSimpleName().equals(type)) {
        found.add(child);
      }
      if (child instanceof Composite inner) {
        collect(inner, type, found);
      }
    }
  }

  /**
   * Ends the sleep of the display again and again: what is waited for may happen on another thread, without an event.
   */
  private static Runnable waking(Display display) {
    return new Runnable() {
      @Override
      public void run() {
        display.timerExec(LOOK_MILLIS, this);
      }
    };
  }

  /**
   * As the loop of the workbench does: what a listener throws is given to the advisor, here through the handler that
   * knows it.
   */
  private static void pump(Display display) {
    try {
      if (!display.readAndDispatch()) {
        display.sleep();
      }
    } catch (RuntimeException e) {
      display.getRuntimeExceptionHandler().accept(e);
    } catch (Error e) {
      display.getRuntimeExceptionHandler().accept(new IllegalStateException(e));
    }
  }
}
