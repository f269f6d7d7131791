package org.robotui.testkit;

/**
 * Tells whether tests can open windows, for
 * {@code @EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)} of JUnit.
 */
public final class Displays {
  /** The name of the condition as JUnit wants it. */
  public static final String AVAILABLE = "org.robotui.testkit.Displays#available";

  /** What is shown where a test is skipped. */
  public static final String REASON = "no display: DISPLAY is not set";

  private Displays() {}

  /**
   * Whether there is a display.
   *
   * @return true where DISPLAY names one
   */
  public static boolean available() {
    String display = System.getenv("DISPLAY");
    return display != null && !display.isBlank();
  }
}
