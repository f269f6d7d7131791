package org.robotui.entity.image;

import java.util.Optional;

/**
 * How numbers become colours.
 *
 * @param map the colours; none to choose by what is shown: grey for brightness, turbo else
 * @param reversed whether the smallest number gets the last colour
 * @param range the numbers at the ends of the map; none to follow what the pictures hold
 * @param depth whether pictures of one number a pixel hold depth: 16 bits in millimetres, floating point in metres
 */
public record Rendering(Optional<ColorMap> map, boolean reversed, Optional<Span> range, boolean depth) {
  /** Depth in turbo, brightness in grey, with a range that follows the pictures. */
  public static final Rendering USUAL = new Rendering(Optional.empty(), false, Optional.empty(), true);
}
