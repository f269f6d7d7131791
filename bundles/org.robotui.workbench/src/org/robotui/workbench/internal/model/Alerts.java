package org.robotui.workbench.internal.model;

import java.util.function.LongSupplier;

/**
 * What the line at the bottom of the windows says. An alert stays until the user has seen it off or a newer one comes;
 * a notice goes by itself, and what it covered is seen again. One thread.
 */
public final class Alerts {
  /** How long a notice stays. */
  static final long NOTICE_NANOS = 10_000_000_000L;

  private final LongSupplier nanoTime;
  private String alert = "";
  private String notice = "";
  private long noticed;

  /** With a monotonic clock, in nanoseconds. */
  public Alerts(LongSupplier nanoTime) {
    this.nanoTime = nanoTime;
  }

  /**
   * Something went wrong.
   *
   * @param ruic which robot it concerns, empty for all
   * @param message what to say
   */
  public void tell(String ruic, String message) {
    alert = ruic.isEmpty() ? message : ruic + ": " + message;
    notice = "";
  }

  /**
   * Something soon is over.
   *
   * @param message what to say
   */
  public void pass(String message) {
    notice = message;
    noticed = nanoTime.getAsLong();
  }

  /** The user has read what is said now. */
  public void dismiss() {
    if (text().equals(alert)) {
      alert = "";
    }
    notice = "";
  }

  /** What is to be said now, empty for nothing. */
  public String text() {
    boolean over = nanoTime.getAsLong() - noticed > NOTICE_NANOS;
    return notice.isEmpty() || over ? alert : notice;
  }
}
