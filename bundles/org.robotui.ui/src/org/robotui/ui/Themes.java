package org.robotui.ui;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.eclipse.swt.graphics.Device;
import org.eclipse.swt.graphics.RGB;

/** The themes there are. */
public final class Themes {
  /** Id of the dark theme. */
  public static final String DARK = "dark";

  /** Id of the light theme. */
  public static final String LIGHT = "light";

  private Themes() {}

  /**
   * The ids of all themes, the default first.
   *
   * @return the ids
   */
  public static List<String> ids() {
    return List.of(DARK, LIGHT);
  }

  /**
   * Makes a theme. The caller owns it and disposes it when nothing that uses it is left.
   *
   * @param device the display
   * @param id one of {@link #ids()}; anything else gives the default
   * @return the theme
   */
  public static Theme of(Device device, String id) {
    return LIGHT.equals(id) ? light(device) : dark(device);
  }

  /**
   * Makes the dark theme. The caller owns it.
   *
   * @param device the display
   * @return the theme
   */
  public static Theme dark(Device device) {
    return new Theme(device, darkPalette());
  }

  /**
   * Makes the light theme. The caller owns it.
   *
   * @param device the display
   * @return the theme
   */
  public static Theme light(Device device) {
    return new Theme(device, lightPalette());
  }

  /**
   * The colours of the dark theme.
   *
   * @return the palette
   */
  public static Palette darkPalette() {
    Map<Role, RGB> colors = new EnumMap<>(Role.class);
    colors.put(Role.GROUND, rgb(0x1b1f24));
    colors.put(Role.PANEL, rgb(0x22272e));
    colors.put(Role.TITLE, rgb(0x262c34));
    colors.put(Role.LINE, rgb(0x353c45));
    colors.put(Role.TEXT, rgb(0xd7dde4));
    colors.put(Role.DIM, rgb(0x8b96a3));
    colors.put(Role.ACCENT, rgb(0x4da3ff));
    colors.put(Role.GOOD, rgb(0x3fb68b));
    colors.put(Role.WARNING, rgb(0xe0a93b));
    colors.put(Role.BAD, rgb(0xe5534b));
    colors.put(Role.LASER, rgb(0xff8a65));
    colors.put(Role.SONAR, rgb(0xb39df0));
    colors.put(Role.WALL, rgb(0x748291));
    colors.put(Role.FLOOR, rgb(0x363e48));
    colors.put(Role.PLAN, rgb(0x3fb68b));
    colors.put(Role.TRAIL, rgb(0x4da3ff));
    return new Palette(DARK, true, colors,
        traces(0x4da3ff, 0xe0a93b, 0x3fb68b, 0xb58cf0, 0xb98a6a, 0xf08cc0, 0x9aa5b1));
  }

  /**
   * The colours of the light theme.
   *
   * @return the palette
   */
  public static Palette lightPalette() {
    Map<Role, RGB> colors = new EnumMap<>(Role.class);
    colors.put(Role.GROUND, rgb(0xf2f4f7));
    colors.put(Role.PANEL, rgb(0xffffff));
    colors.put(Role.TITLE, rgb(0xf6f8fa));
    colors.put(Role.LINE, rgb(0xd5dbe2));
    colors.put(Role.TEXT, rgb(0x1f2730));
    colors.put(Role.DIM, rgb(0x5b6673));
    colors.put(Role.ACCENT, rgb(0x0b63c4));
    colors.put(Role.GOOD, rgb(0x0a7350));
    colors.put(Role.WARNING, rgb(0x875500));
    colors.put(Role.BAD, rgb(0xc4302b));
    colors.put(Role.LASER, rgb(0xd1491c));
    colors.put(Role.SONAR, rgb(0x7048c8));
    colors.put(Role.WALL, rgb(0x56616e));
    colors.put(Role.FLOOR, rgb(0xd9e0e8));
    colors.put(Role.PLAN, rgb(0x0a7350));
    colors.put(Role.TRAIL, rgb(0x2f7fd6));
    return new Palette(LIGHT, false, colors,
        traces(0x0b63c4, 0xb86e00, 0x0a7350, 0x7048c8, 0x7a4a2b, 0xc03a86, 0x5b6673));
  }

  private static List<RGB> traces(int... values) {
    return IntStream.of(values).mapToObj(Themes::rgb).toList();
  }

  private static RGB rgb(int value) {
    return new RGB(value >> 16 & 0xff, value >> 8 & 0xff, value & 0xff);
  }
}
