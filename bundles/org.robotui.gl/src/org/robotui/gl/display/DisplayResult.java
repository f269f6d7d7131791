package org.robotui.gl.display;

import java.util.List;
import org.robotui.gl.shape.Part;

/**
 * What a display shows.
 *
 * @param parts what is to be drawn, in the fixed frame
 * @param status how it is
 * @param dropped values that it could not show, since it was made: too many, broken
 */
public record DisplayResult(List<Part> parts, DisplayStatus status, long dropped) {
  /**
   * Copies the list.
   *
   * @param parts what is to be drawn
   * @param status how it is
   * @param dropped values not shown
   */
  public DisplayResult {
    parts = List.copyOf(parts);
  }

  /**
   * All is well.
   *
   * @param parts what is to be drawn
   * @param summary some words: how much is seen
   * @return the result
   */
  public static DisplayResult shown(List<Part> parts, String summary) {
    return new DisplayResult(parts, new DisplayStatus.Shown(summary), 0);
  }

  /**
   * Nothing is to be drawn.
   *
   * @param why the reason
   * @return the result
   */
  public static DisplayResult nothing(DisplayStatus why) {
    return new DisplayResult(List.of(), why, 0);
  }
}
