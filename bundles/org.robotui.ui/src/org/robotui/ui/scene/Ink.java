package org.robotui.ui.scene;

import org.eclipse.swt.graphics.Color;
import org.eclipse.swt.graphics.RGB;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;

/** In which colour something is painted. */
public sealed interface Ink {
  /** That which a thing of its kind usually has. */
  Ink USUAL = new Usual();

  /** The usual colour of its kind. */
  record Usual() implements Ink {}

  /**
   * One of the theme's traces, which tell robots from one another.
   *
   * @param number from 0, taken modulo their number
   */
  record Trace(int number) implements Ink {}

  /**
   * One that the user has chosen.
   *
   * @param rgb the colour
   */
  record Chosen(RGB rgb) implements Ink {}

  /**
   * The colour. Display thread.
   *
   * @param theme colours of the window
   * @param usual what a thing of its kind has
   * @return a colour that nobody disposes of
   */
  default Color of(Theme theme, Role usual) {
    return of(theme, theme.color(usual));
  }

  /**
   * The colour. Display thread.
   *
   * @param theme colours of the window
   * @param usual what a thing of its kind has
   * @return a colour that nobody disposes of
   */
  default Color of(Theme theme, Color usual) {
    return switch (this) {
      case Usual own -> usual;
      case Trace trace -> theme.traces().get(Math.floorMod(trace.number(), theme.traces().size()));
      case Chosen chosen -> new Color(chosen.rgb());
    };
  }
}
