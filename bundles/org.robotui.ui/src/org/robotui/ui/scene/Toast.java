package org.robotui.ui.scene;

import java.util.Optional;

/** A brief message: it goes by itself. Display thread. */
public final class Toast {
  /** How long it is shown, milliseconds. */
  public static final int MILLIS = 4000;

  private Optional<CommandNotice> told = Optional.empty();
  private long untilNanos;

  /** Nothing is said. */
  public Toast() {
    // Fields say it.
  }

  /**
   * Says something, in place of what was said before.
   *
   * @param message what became of something
   * @param nowNanos {@link System#nanoTime()}
   */
  public void say(CommandNotice message, long nowNanos) {
    told = Optional.of(message);
    untilNanos = nowNanos + MILLIS * 1_000_000L;
  }

  /** Ends the message. */
  public void clear() {
    told = Optional.empty();
  }

  /**
   * The message, while it is to be shown.
   *
   * @param nowNanos {@link System#nanoTime()}
   * @return the message, or none
   */
  public Optional<CommandNotice> at(long nowNanos) {
    return told.filter(t -> nowNanos - untilNanos < 0);
  }
}
