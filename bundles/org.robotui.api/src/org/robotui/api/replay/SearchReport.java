package org.robotui.api.replay;

import java.util.List;

/**
 * What became of a search.
 *
 * @param values how many values were looked at
 * @param problems what was not looked at and why, a sentence each; empty where all is well
 */
public record SearchReport(long values, List<String> problems) {
  /**
   * Copies the list.
   *
   * @param values how many values were looked at
   * @param problems sentences
   */
  public SearchReport {
    problems = List.copyOf(problems);
  }
}
