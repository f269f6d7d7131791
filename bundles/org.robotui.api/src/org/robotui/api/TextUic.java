package org.robotui.api;

import java.util.List;

/** A view in a terminal. */
public interface TextUic extends Uic {
  /**
   * What to show now. Called on the terminal's thread after a tick that had something new.
   *
   * @param columns width of the terminal
   * @param rows height available
   * @return at most that many lines, without control characters
   */
  List<String> lines(int columns, int rows);
}
