package org.robotui.core.internal.fence;

import org.slf4j.Logger;

/** What foreign code threw, in words and in the log. It is foreign as well: its message may throw, or have no end. */
public final class Thrown {
  private static final int LONGEST = 300;

  private Thrown() {}

  /** A part of a sentence for the user. */
  public static String text(Throwable thrown) {
    String described = described(thrown);
    String text = described.length() > LONGEST ? described.substring(0, LONGEST) + "..." : described;
    // The thread that finds no memory left need not be the one that took it.
    return thrown instanceof OutOfMemoryError ? text + ", which another may have used up" + howToGetMore(text) + ","
        : text;
  }

  /** Threads and memory beside the heap have other bounds. */
  private static String howToGetMore(String text) {
    if (!text.contains("heap space")) {
      return "";
    }
    long bound = HeapBound.bytes();
    return " (RobotUI may take " + HeapBound.megabytes(bound) + " MB; " + HeapBound.remedy(bound) + " gives it more)";
  }

  private static String described(Throwable thrown) {
    try {
      return String.valueOf(thrown.toString());
    } catch (RuntimeException | Error e) { // the message is foreign code, too
      return thrown.getClass().getName();
    }
  }

  /**
   * Logs it with its stack, whatever happens: the threads that do so must go on even where there is no memory for a
   * line.
   */
  public static void log(Logger log, String message, Throwable thrown) {
    try {
      log.error("{}: {}", message, text(thrown), loggable(thrown));
    } catch (RuntimeException | Error e) {
      // There is nowhere left to say so.
    }
  }

  private static Throwable loggable(Throwable thrown) {
    try {
      thrown.toString();
      return thrown;
    } catch (RuntimeException | Error e) {
      Throwable stack = new Throwable(thrown.getClass().getName());
      stack.setStackTrace(thrown.getStackTrace());
      return stack;
    }
  }
}
