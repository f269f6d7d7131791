package org.robotui.entity.image;

import org.robotui.gl.shape.ColorRamp;

/** Colours for numbers, as even to the eye as colours can be. */
public enum ColorMap {
  /** Rainbow without false edges: the most steps that can be told apart. */
  TURBO(ColorRamp.TURBO, 0x3c3c42),
  /** From dark violet to yellow: also for those who see few colours, and in print. */
  VIRIDIS(ColorRamp.VIRIDIS, 0x3c3c42),
  /** From dark to light. */
  GREY(ColorRamp.GREY, 0x2a2f5e);

  private final ColorRamp ramp;
  private final int nothing;

  ColorMap(ColorRamp ramp, int nothing) {
    this.ramp = ramp;
    this.nothing = nothing;
  }

  /**
   * As users read it.
   *
   * @return the label
   */
  public String label() {
    return ramp.label();
  }

  /**
   * As it is written in settings.
   *
   * @return the name in lower case
   */
  public String id() {
    return ramp.id();
  }

  /**
   * The colour where nothing was measured; none of the map's own.
   *
   * @return red, green, blue as 0xrrggbb
   */
  public int nothing() {
    return nothing;
  }

  /**
   * A colour.
   *
   * @param share where in the map, 0 to 1; clamped
   * @return red, green, blue as 0xrrggbb
   */
  public int rgb(double share) {
    return ramp.rgb(share);
  }

  /**
   * The map in steps.
   *
   * @param steps how many, at least 2
   * @param reversed whether it begins with its last colour
   * @return the colours from the smallest to the largest number
   */
  public int[] table(int steps, boolean reversed) {
    return ramp.table(steps, reversed);
  }
}
