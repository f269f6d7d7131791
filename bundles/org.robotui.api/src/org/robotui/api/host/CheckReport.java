package org.robotui.api.host;

import java.util.List;
import java.util.Map;

/**
 * What becomes of a configuration.
 *
 * @param problems what is wrong with it, in the order of the file
 * @param matches what matching says, by RUIC; streams that only a running robot offers are pending
 * @param reuse which bundles its RUICs use
 */
public record CheckReport(List<Problem> problems, Map<String, List<Match>> matches, ReuseReport reuse) {
  /**
   * Whether it can be used.
   *
   * @return false where there is an error
   */
  public boolean usable() {
    return problems.stream().noneMatch(p -> p.severity() == Problem.Severity.ERROR);
  }
}
