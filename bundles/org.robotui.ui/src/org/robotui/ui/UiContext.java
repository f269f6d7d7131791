package org.robotui.ui;

/** What a window gives to a view. Display thread only. */
public interface UiContext {
  /**
   * Colours and fonts. When the user changes the theme, the view's control is made anew.
   *
   * @return the theme
   */
  Theme theme();

  /**
   * Says something short at the right of the view's title line, for example {@code follow - odom - 0.05 m/px}.
   *
   * @param text the text, empty for none
   */
  void note(String text);
}
