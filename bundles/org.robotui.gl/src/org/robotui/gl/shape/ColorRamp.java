package org.robotui.gl.shape;

import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;

/**
 * Colours for numbers, as even to the eye as colours can be: those of the camera view's depth pictures, so that a
 * distance looks the same everywhere.
 */
public enum ColorRamp {
  /** Rainbow without false edges: the most steps that can be told apart. */
  TURBO("Turbo",
      "30123b392a734040a14456c7466be3467ff64293ff37a7fa29bbec1dcdd818dcc31ee8b031f2994cf97e6bfd648aff4da3fd3cb8f735cced34"
          + "dee037edd03af8c03afdae35fe982cfb8022f56817ec520fe04009d23105c02302ac1701950d017a0403"),
  /** From dark violet to yellow: also for those who see few colours, and in print. */
  VIRIDIS("Viridis",
      "440154470d6048186a482374472d7b4536814240863f49893b528b375a8d33638d2f6a8e2c728e297a8e26818e23898e21908c1f988b1f9f88"
          + "21a68528ae8031b57b3ebc744cc26c5dc9636ece5882d34c96d83fabdc32c0df24d5e21aeae51afde725"),
  /** From dark to light. */
  GREY("Grey", "181818ffffff");

  private static final int HEX_DIGITS = 6;
  private static final int HEX = 16;
  private static final int BYTE = 0xff;

  private final String label;
  private final int[] anchors;

  ColorRamp(String label, String anchors) {
    this.label = label;
    this.anchors = new int[anchors.length() / HEX_DIGITS];
    for (int i = 0; i < this.anchors.length; i++) {
      this.anchors[i] = Integer.parseInt(anchors.substring(i * HEX_DIGITS, (i + 1) * HEX_DIGITS), HEX);
    }
  }

  /**
   * As users read it.
   *
   * @return the label
   */
  public String label() {
    return label;
  }

  /**
   * As it is written in settings.
   *
   * @return the name in lower case
   */
  public String id() {
    return name().toLowerCase(Locale.ROOT);
  }

  /**
   * The ramp that is written so in settings.
   *
   * @param id as {@link #id()}
   * @return the ramp
   */
  public static ColorRamp named(String id) {
    return valueOf(id.toUpperCase(Locale.ROOT));
  }

  /**
   * What can be written in settings.
   *
   * @return the ids
   */
  public static List<String> ids() {
    return Stream.of(values()).map(ColorRamp::id).toList();
  }

  /**
   * A colour.
   *
   * @param share where in the map, 0 to 1; clamped, no number is 0
   * @return red, green, blue as 0xrrggbb
   */
  public int rgb(double share) {
    double at = (share > 0 ? Math.min(share, 1) : 0) * (anchors.length - 1);
    int low = Math.min((int) at, anchors.length - 2);
    double part = at - low;
    return channel(low, part, 16) << 16 | channel(low, part, 8) << 8 | channel(low, part, 0);
  }

  /**
   * The map in steps.
   *
   * @param steps how many, at least 2
   * @param reversed whether it begins with its last colour
   * @return the colours from the smallest to the largest number
   */
  public int[] table(int steps, boolean reversed) {
    int[] table = new int[steps];
    for (int i = 0; i < steps; i++) {
      double share = (double) i / (steps - 1);
      table[i] = rgb(reversed ? 1 - share : share);
    }
    return table;
  }

  private int channel(int low, double part, int shift) {
    return (int) Math.round((anchors[low] >> shift & BYTE) * (1 - part) + (anchors[low + 1] >> shift & BYTE) * part);
  }
}
