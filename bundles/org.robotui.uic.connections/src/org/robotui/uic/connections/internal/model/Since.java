package org.robotui.uic.connections.internal.model;

import org.robotui.ui.Figures;

/**
 * How long something has been as it is.
 *
 * @param seconds since it became so, or since it was first seen so
 * @param seen whether it was seen to become so; else it may have been so for longer
 */
public record Since(double seconds, boolean seen) {
  private static final double MINUTE = 60;

  /** In words: for example {@code 12 s}, {@code > 3 min} where the beginning was not seen. */
  public String words() {
    if (seconds < 1) {
      return seen ? "now" : "";
    }
    return (seen ? "" : "> ") + (seconds < MINUTE ? Figures.of(Math.floor(seconds), 0, "s") : Figures.age(seconds));
  }
}
