package org.robotui.core.internal.config.model;

import java.util.List;
import org.robotui.api.host.Problem;

/**
 * What was read.
 *
 * @param problems what is wrong, in the order of the file
 * @param ruics the RUICs without errors
 */
public record ConfigResult(List<Problem> problems, List<RuicConfig> ruics) {
  /**
   * Copies the lists.
   *
   * @param problems what is wrong
   * @param ruics the RUICs without errors
   */
  public ConfigResult {
    problems = List.copyOf(problems);
    ruics = List.copyOf(ruics);
  }
}
