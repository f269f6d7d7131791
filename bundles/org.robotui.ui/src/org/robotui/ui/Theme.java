package org.robotui.ui;

import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Color;
import org.eclipse.swt.graphics.Device;
import org.eclipse.swt.graphics.Font;
import org.eclipse.swt.graphics.FontData;
import org.eclipse.swt.graphics.RGB;

/**
 * Colours and fonts of a look. Colours may be read on any thread; fonts belong to the display. Whoever made it disposes
 * it; views do not.
 */
public final class Theme {
  /** The distance that other distances are multiples of, pixels. */
  public static final int STEP = 4;

  /** From the edge of a part to its content, pixels. */
  public static final int EDGE = 12;

  private static final double POINTS_PER_PIXEL = 0.75;
  private static final double LEGIBLE_ON_FILL = 3;

  private final Palette palette;
  private final Map<Role, Color> colors = new EnumMap<>(Role.class);
  private final Map<Face, Font> fonts = new EnumMap<>(Face.class);
  private final List<Color> traces;

  /**
   * Makes the fonts.
   *
   * @param device the display
   * @param palette the colours
   */
  public Theme(Device device, Palette palette) {
    this.palette = palette;
    palette.colors().forEach((role, rgb) -> colors.put(role, new Color(rgb)));
    traces = palette.traces().stream().map(Color::new).toList();
    String text = device.getSystemFont().getFontData()[0].getName();
    Arrays.stream(Face.values()).forEach(face -> fonts.put(face, font(device, face, text)));
  }

  /**
   * The id of the theme.
   *
   * @return for example {@code dark}
   */
  public String id() {
    return palette.id();
  }

  /**
   * Whether text is lighter than what is behind it.
   *
   * @return true for dark themes
   */
  public boolean dark() {
    return palette.dark();
  }

  /**
   * The colours without a display.
   *
   * @return the palette
   */
  public Palette palette() {
    return palette;
  }

  /**
   * The colour of a role; not to be disposed.
   *
   * @param role the role
   * @return its colour
   */
  public Color color(Role role) {
    return colors.get(role);
  }

  /**
   * A colour between two roles, for hovered rows and quiet fills; needs no disposal.
   *
   * @param over the role on top
   * @param under the role below
   * @param share how much of the upper one is seen, 0 to 1
   * @return the colour, opaque
   */
  public Color mix(Role over, Role under, double share) {
    return new Color(Palette.mix(palette.rgb(over), palette.rgb(under), share));
  }

  /**
   * The colour of text on a filled area.
   *
   * @param fill the role of the area
   * @return white or nearly black
   */
  public Color on(Role fill) {
    RGB white = new RGB(255, 255, 255);
    boolean legible = Palette.contrast(white, palette.rgb(fill)) >= LEGIBLE_ON_FILL;
    return new Color(legible ? white : new RGB(16, 20, 24));
  }

  /**
   * A font; not to be disposed.
   *
   * @param face typeface and size
   * @return the font
   */
  public Font font(Face face) {
    return fonts.get(face);
  }

  /**
   * Colours of the traces of a plot in an order that colour-blind users can tell apart: blue, orange, green, purple,
   * brown, pink, grey.
   *
   * @return the colours; not to be disposed
   */
  public List<Color> traces() {
    return traces;
  }

  /** Disposes the fonts. Display thread only; nothing may use the theme after that. */
  public void dispose() {
    fonts.values().forEach(Font::dispose);
  }

  private static Font font(Device device, Face face, String text) {
    String name = face.figures() ? monospaced() : text;
    int style = face.strong() ? SWT.BOLD : SWT.NORMAL;
    // Only the textual form takes fractions of a point; 12.5 pixels are 9.375 points.
    return new Font(device, new FontData("1|" + name + "|" + face.pixels() * POINTS_PER_PIXEL + "|" + style + "|"));
  }

  private static String monospaced() {
    return switch (SWT.getPlatform()) {
      case "win32" -> "Consolas";
      case "cocoa" -> "Menlo";
      default -> "Monospace";
    };
  }
}
