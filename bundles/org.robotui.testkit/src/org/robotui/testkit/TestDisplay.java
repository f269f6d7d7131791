package org.robotui.testkit;

import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import org.eclipse.swt.graphics.DeviceData;
import org.eclipse.swt.widgets.Display;

/** One display for all tests of this thread, since GTK does not like to be started twice; it tracks its resources. */
public final class TestDisplay {
  private static final long PATIENCE = TimeUnit.SECONDS.toNanos(10);

  private TestDisplay() {}

  /**
   * The display of this thread.
   *
   * @return the one that is there, else a new one
   */
  public static Display get() {
    return Optional.ofNullable(Display.getCurrent()).orElseGet(TestDisplay::open);
  }

  /**
   * Runs what the display has to do until something holds.
   *
   * @param condition what
   * @throws AssertionError where it does not within ten seconds
   */
  public static void until(BooleanSupplier condition) {
    long end = System.nanoTime() + PATIENCE;
    while (!condition.getAsBoolean()) {
      if (System.nanoTime() > end) {
        throw new AssertionError("waited in vain");
      }
      if (!get().readAndDispatch()) {
        Thread.onSpinWait();
      }
    }
  }

  private static Display open() {
    DeviceData tracked = new DeviceData();
    tracked.tracking = true;
    return new Display(tracked);
  }
}
