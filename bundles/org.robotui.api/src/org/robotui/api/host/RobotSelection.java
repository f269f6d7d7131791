package org.robotui.api.host;

import java.util.Set;

/**
 * Which of a RUIC's robots the user means. All its views share it: what is selected in a table is marked on a map, and
 * commanded from there. Safe for all threads; never blocks.
 */
public interface RobotSelection {
  /**
   * The selected robots.
   *
   * @return their names, in the order in which they were selected; may be empty, and may name robots that have gone
   */
  Set<String> robots();

  /**
   * Selects these robots, and no others.
   *
   * @param robots their names
   */
  void set(Set<String> robots);
}
