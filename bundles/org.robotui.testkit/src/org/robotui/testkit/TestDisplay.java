package org.robotui.testkit;

import java.util.Optional;
import org.eclipse.swt.graphics.DeviceData;
import org.eclipse.swt.widgets.Display;

/** One display for all tests of this thread, since GTK does not like to be started twice; it tracks its resources. */
public final class TestDisplay {
  private TestDisplay() {}

  /**
   * The display of this thread.
   *
   * @return the one that is there, else a new one
   */
  public static Display get() {
    return Optional.ofNullable(Display.getCurrent()).orElseGet(TestDisplay::open);
  }

  private static Display open() {
    DeviceData tracked = new DeviceData();
    tracked.tracking = true;
    return new Display(tracked);
  }
}
