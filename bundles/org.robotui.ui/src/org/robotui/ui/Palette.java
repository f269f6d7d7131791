package org.robotui.ui;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import org.eclipse.swt.graphics.RGB;

/**
 * The colours of a theme, without a display.
 *
 * @param id the word by which the theme is chosen, for example {@code dark}
 * @param dark true where text is lighter than what is behind it
 * @param colors a colour for every role
 * @param traces colours of the traces of a plot, in an order that colour-blind users can tell apart
 */
public record Palette(String id, boolean dark, Map<Role, RGB> colors, List<RGB> traces) {
  private static final double RED_WEIGHT = 0.2126;
  private static final double GREEN_WEIGHT = 0.7152;
  private static final double BLUE_WEIGHT = 0.0722;
  private static final double FLARE = 0.05;

  /**
   * Copies and checks that no role lacks a colour.
   *
   * @param id the word by which the theme is chosen
   * @param dark true where text is lighter than what is behind it
   * @param colors a colour for every role
   * @param traces at least one
   */
  public Palette {
    colors = Map.copyOf(new EnumMap<>(colors));
    traces = List.copyOf(traces);
    for (Role role : Role.values()) {
      if (!colors.containsKey(role)) {
        throw new IllegalArgumentException("the palette '" + id + "' has no colour for " + role);
      }
    }
  }

  /**
   * The colour of a role.
   *
   * @param role the role
   * @return its colour
   */
  public RGB rgb(Role role) {
    return colors.get(role);
  }

  /**
   * Mixes two colours.
   *
   * @param over the colour on top
   * @param under the colour below
   * @param share how much of the upper one is seen, 0 to 1
   * @return the mixture, opaque
   */
  public static RGB mix(RGB over, RGB under, double share) {
    return new RGB(
        mix(over.red, under.red, share), mix(over.green, under.green, share), mix(over.blue, under.blue, share));
  }

  /**
   * The contrast of two colours as WCAG 2 defines it.
   *
   * @param one a colour
   * @param other another colour
   * @return from 1 (the same) to 21 (black and white)
   */
  public static double contrast(RGB one, RGB other) {
    double a = luminance(one);
    double b = luminance(other);
    return (Math.max(a, b) + FLARE) / (Math.min(a, b) + FLARE);
  }

  private static int mix(int over, int under, double share) {
    return (int) Math.round(under + (over - under) * Math.clamp(share, 0.0, 1.0));
  }

  private static double luminance(RGB c) {
    return RED_WEIGHT * linear(c.red) + GREEN_WEIGHT * linear(c.green) + BLUE_WEIGHT * linear(c.blue);
  }

  private static double linear(int channel) {
    double c = channel / 255.0;
    return c <= 0.04045 ? c / 12.92 : Math.pow((c + 0.055) / 1.055, 2.4);
  }
}
