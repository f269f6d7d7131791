package org.robotui.entity.image.internal;

import java.util.Optional;

/** The sizes of pictures that are shown. */
public final class Limits {
  private static final int LONGEST_EDGE = 16_384;
  private static final long MOST_PIXELS = 32L << 20;

  private Limits() {}

  /**
   * Why a size is not allowed.
   *
   * @param width pixels
   * @param height pixels
   * @return a sentence, or none where it is allowed
   */
  public static Optional<String> refusal(int width, int height) {
    if (width <= 0 || height <= 0) {
      return Optional.of("the picture is empty (" + width + "\u00d7" + height + ")");
    }
    boolean fits = width <= LONGEST_EDGE && height <= LONGEST_EDGE && (long) width * height <= MOST_PIXELS;
    return fits ? Optional.empty()
        : Optional.of("the picture is too large (" + width + "\u00d7" + height + "); at most "
            + LONGEST_EDGE + " pixels an edge and " + (MOST_PIXELS >> 20) + " million in all are shown");
  }
}
