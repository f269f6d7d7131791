package org.robotui.ui;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

/**
 * The icons: strokes of one weight in a square of 16 units, y downwards. The outline is a list of {@code M x y},
 * {@code L x y}, {@code C x1 y1 x2 y2 x y}, {@code Z} and, beyond the usual, {@code O x y r} for a circle.
 */
public enum Icon {
  /** Keep the robot in the middle. */
  FOLLOW("O 8 8 3 M 8 1 L 8 4 M 8 12 L 8 15 M 1 8 L 4 8 M 12 8 L 15 8"),
  /** Show all. */
  FIT("M 2 6 L 2 2 L 6 2 M 10 2 L 14 2 L 14 6 M 14 10 L 14 14 L 10 14 M 6 14 L 2 14 L 2 10"),
  /** Measure. */
  RULER("M 1.5 11 L 11 1.5 L 14.5 5 L 5 14.5 Z M 4.5 8 L 6 9.5 M 7.5 5 L 9 6.5"),
  /** A goal to go to. */
  TARGET("O 8 8 6 O 8 8 2.2"),
  /** Places to go to, one after the other. */
  ROUTE("O 3.2 12.8 1.8 O 12.8 3.2 1.8 M 5 12.6 C 12.5 12 3.5 4 11 3.4"),
  /** Where the robot is. */
  POSE("M 8 1.5 L 13 14 L 8 11 L 3 14 Z"),
  /** What is shown. */
  LAYERS("M 8 2 L 14.5 5.5 L 8 9 L 1.5 5.5 Z M 1.5 9.5 L 8 13 L 14.5 9.5"),
  /** Go on. */
  PLAY("M 4.5 2.5 L 13 8 L 4.5 13.5 Z"),
  /** Hold on. */
  PAUSE("M 5 3 L 5 13 M 11 3 L 11 13"),
  /** One further. */
  STEP_FORWARD("M 3.5 3 L 10 8 L 3.5 13 Z M 12.5 3 L 12.5 13"),
  /** One back. */
  STEP_BACK("M 12.5 3 L 6 8 L 12.5 13 Z M 3.5 3 L 3.5 13"),
  /** Again from the beginning. */
  LOOP("M 4.5 12 L 11 12 C 15.5 12 15.5 5 11 5 L 5 5 C 3.4 5 2.2 6 1.9 7.5 M 7.3 2.6 L 4.8 5 L 7.3 7.4"),
  /** A place that is noted. */
  BOOKMARK("M 4 2 L 12 2 L 12 14 L 8 10.5 L 4 14 Z"),
  /** End. */
  STOP("M 3.5 3.5 L 12.5 3.5 L 12.5 12.5 L 3.5 12.5 Z"),
  /** More. */
  PLUS("M 8 2.5 L 8 13.5 M 2.5 8 L 13.5 8"),
  /** Less. */
  MINUS("M 2.5 8 L 13.5 8"),
  /** Settings. */
  GEAR("O 8 8 2.2 O 8 8 5 M 8 1 L 8 3 M 8 13 L 8 15 M 1 8 L 3 8 M 13 8 L 15 8 M 3 3 L 4.5 4.5 M 11.5 11.5 L 13 13 "
      + "M 3 13 L 4.5 11.5 M 11.5 4.5 L 13 3"),
  /** Begin anew. */
  RESTART("M 13.5 8 C 13.5 11 11 13.5 8 13.5 C 5 13.5 2.5 11 2.5 8 C 2.5 5 5 2.5 8 2.5 C 10 2.5 11.7 3.5 12.8 5 "
      + "M 13 1.8 L 13 5.2 L 9.6 5.2"),
  /** As it was before. */
  UNDO("M 5.5 2.5 L 2.5 5.5 L 5.5 8.5 M 2.5 5.5 L 9.5 5.5 C 15 5.5 15 13.5 9.5 13.5 L 6 13.5"),
  /** A camera or its picture. */
  CAMERA("M 1.5 5 L 5 5 L 6.2 3 L 9.8 3 L 11 5 L 14.5 5 L 14.5 13 L 1.5 13 Z O 8 8.8 2.4"),
  /** Copy. */
  COPY("M 5.5 5.5 L 13.5 5.5 L 13.5 13.5 L 5.5 13.5 Z M 3.5 10.5 L 2.5 10.5 L 2.5 2.5 L 10.5 2.5 L 10.5 3.5"),
  /** Keep in a file. */
  SAVE("M 8 2 L 8 10 M 4.5 6.8 L 8 10.3 L 11.5 6.8 M 2.5 10.5 L 2.5 13.5 L 13.5 13.5 L 13.5 10.5"),
  /** Seen or not. */
  EYE("M 1 8 C 3 4.5 5.3 3 8 3 C 10.7 3 13 4.5 15 8 C 13 11.5 10.7 13 8 13 C 5.3 13 3 11.5 1 8 Z O 8 8 2"),
  /** How often values are there. */
  BARS(
      "M 1.5 13.5 L 14.5 13.5 M 3 13.5 L 3 10 L 6 10 L 6 13.5 M 6 10 L 6 3 L 9.5 3 L 9.5 13.5 M 9.5 7 L 13 7 L 13 13.5"),
  /** Close. */
  CLOSE("M 3.5 3.5 L 12.5 12.5 M 12.5 3.5 L 3.5 12.5"),
  /** It is so. */
  CHECK("M 2.5 8.5 L 6.5 12.5 L 13.5 4"),
  /** As large as before. */
  RESTORE("M 5.5 2.5 L 13.5 2.5 L 13.5 10.5 M 2.5 5.5 L 10.5 5.5 L 10.5 13.5 L 2.5 13.5 Z"),
  /** A list of choices. */
  MORE("O 3 8 0.8 O 8 8 0.8 O 13 8 0.8"),
  /** Drive. */
  STEER("O 8 8 6.3 O 8 8 1.8 M 1.9 7 L 6.2 7.6 M 14.1 7 L 9.8 7.6 M 8 9.8 L 8 14.3"),
  /** Connect. */
  LINK(
      "M 6.5 9.5 L 9.5 6.5 M 7 4.5 L 9 2.5 C 11 0.5 15.5 5 13.5 7 L 11.5 9 M 9 11.5 L 7 13.5 C 5 15.5 0.5 11 2.5 9 L 4.5 7"),
  /** What is within is seen. */
  OPEN("M 3.5 6 L 8 10.5 L 12.5 6"),
  /** What is within is not seen. */
  CLOSED("M 6 3.5 L 10.5 8 L 6 12.5"),
  /** Looks for something. */
  FIND("O 6.7 6.7 4.7 M 10.3 10.3 L 14.3 14.3"),
  /** Words of a robot. */
  TEXT("M 2 4 L 14 4 M 2 8 L 14 8 M 2 12 L 9 12");

  /** Edge of the square in which icons are drawn. */
  public static final int UNITS = 16;

  private final String outline;

  Icon(String outline) {
    this.outline = outline;
  }

  /**
   * How it is drawn.
   *
   * @return commands and numbers, separated by blanks
   */
  public String outline() {
    return outline;
  }

  /**
   * The name by which view actions ask for it.
   *
   * @return the name in lower case
   */
  public String id() {
    return name().toLowerCase(Locale.ROOT);
  }

  /**
   * Finds an icon.
   *
   * @param id its name
   * @return the icon, or none
   */
  public static Optional<Icon> find(String id) {
    return Arrays.stream(values()).filter(icon -> icon.id().equals(id)).findFirst();
  }
}
