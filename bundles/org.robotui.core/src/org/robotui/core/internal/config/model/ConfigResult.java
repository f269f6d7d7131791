package org.robotui.core.internal.config.model;

import java.util.List;
import org.robotui.api.bridge.BridgeConfig;
import org.robotui.api.host.Problem;
import org.robotui.api.host.WindowConfig;

/**
 * What was read.
 *
 * @param problems what is wrong, in the order of the file
 * @param ruics the RUICs without errors
 * @param windows the windows that it asks for, of RUICs that it names
 * @param bridges the bridges without errors, between RUICs that it names
 */
public record ConfigResult(List<Problem> problems, List<RuicConfig> ruics, List<WindowConfig> windows,
    List<BridgeConfig> bridges) {
  /**
   * Copies the lists.
   *
   * @param problems what is wrong
   * @param ruics the RUICs without errors
   * @param windows the windows
   * @param bridges the bridges
   */
  public ConfigResult {
    problems = List.copyOf(problems);
    ruics = List.copyOf(ruics);
    windows = List.copyOf(windows);
    bridges = List.copyOf(bridges);
  }

  /**
   * Of a file that cannot be used.
   *
   * @param problems what is wrong
   * @return nothing else
   */
  public static ConfigResult unusable(List<Problem> problems) {
    return new ConfigResult(problems, List.of(), List.of(), List.of());
  }
}
