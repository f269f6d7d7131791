package org.robotui.ros2;

import java.time.Duration;
import java.util.function.BooleanSupplier;
import org.robotui.ros2.internal.link.Waiting;

/** Waits for what happens on other threads. */
public final class Eventually {

  private Eventually() {}

  public static void await(String what, BooleanSupplier condition) {
    if (!Waiting.until(Duration.ofSeconds(30), () -> false, condition)) {
      throw new AssertionError("did not happen: " + what);
    }
  }
}
