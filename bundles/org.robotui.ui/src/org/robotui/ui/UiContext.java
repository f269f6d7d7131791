package org.robotui.ui;

import java.util.function.Consumer;

/** What a window gives to a view. Display thread only. */
public interface UiContext {
  /**
   * A window of which a view needs to know no more than this.
   *
   * @param theme colours and fonts
   * @param note is told what the view says of itself
   * @return what the view is given
   */
  static UiContext of(Theme theme, Consumer<String> note) {
    return new UiContext() {
      @Override
      public Theme theme() {
        return theme;
      }

      @Override
      public void note(String text) {
        note.accept(text);
      }
    };
  }

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

  /**
   * The time by which the window measures how long its views take to paint. A window of a test may have one of its own,
   * by which nothing is late.
   *
   * @return monotonic nanoseconds, as of {@link System#nanoTime()}
   */
  default long nanos() {
    return System.nanoTime();
  }
}
