package org.robotui.ui;

/** The typefaces and sizes in use. Sizes are in pixels at a zoom of 100 percent. */
public enum Face {
  /** Notes, units, second lines. */
  SMALL(11, false, false),
  /** Headings of groups in lists, written in capitals. */
  SMALL_STRONG(11, true, false),
  /** Text. */
  BODY(12.5, false, false),
  /** The chosen tab, the title of a message. */
  BODY_STRONG(12.5, true, false),
  /** Names: of robots, in lists with large rows. */
  NAME(13.5, false, false),
  /** Titles, and the name of what is selected. */
  TITLE(13.5, true, false),
  /** Small figures of fixed width. */
  SMALL_FIGURES(11, false, true),
  /** Figures of fixed width. */
  FIGURES(12.5, false, true),
  /** The figures that matter most in a view. */
  LARGE_FIGURES(13.5, false, true);

  private final double pixels;
  private final boolean strong;
  private final boolean figures;

  Face(double pixels, boolean strong, boolean figures) {
    this.pixels = pixels;
    this.strong = strong;
    this.figures = figures;
  }

  /**
   * The size.
   *
   * @return pixels at a zoom of 100 percent
   */
  public double pixels() {
    return pixels;
  }

  /**
   * Whether it is heavier than text.
   *
   * @return true for titles
   */
  public boolean strong() {
    return strong;
  }

  /**
   * Whether all digits are equally wide.
   *
   * @return true for figures
   */
  public boolean figures() {
    return figures;
  }
}
