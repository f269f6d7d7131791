package org.robotui.api.host;

import java.nio.file.Path;
import java.util.List;

/**
 * A configuration that runs was changed by somebody in its file. Where something is wrong with it, what runs goes on as
 * it was.
 *
 * @param file which
 * @param problems what is wrong with it now
 * @param steps what the change means for what runs
 */
public record ConfigChange(Path file, List<Problem> problems, List<Step> steps) {
  /** One consequence. */
  public sealed interface Step {
    /**
     * Which RUIC.
     *
     * @return its name
     */
    String ruic();

    /**
     * A robot interface is configured differently: {@link Ruic#exchange} takes that up.
     *
     * @param ruic name of the RUIC
     * @param wanted as written now
     */
    record Exchanged(String ruic, InterfaceConfig wanted) implements Step {}

    /**
     * Something that only holds after {@link Ruic#restart()}.
     *
     * @param ruic name of the RUIC
     * @param what for example {@code uics, layout}
     */
    record NeedsRestart(String ruic, String what) implements Step {}

    /**
     * Something that holds already.
     *
     * @param ruic name of the RUIC
     * @param what for example {@code safety}
     */
    record TakenUp(String ruic, String what) implements Step {}

    /**
     * A new RUIC, which is started.
     *
     * @param ruic its name
     */
    record Added(String ruic) implements Step {}

    /**
     * A RUIC that is not in the file any more; it goes on until it is removed.
     *
     * @param ruic its name
     */
    record Gone(String ruic) implements Step {}
  }

  /**
   * Copies the lists.
   *
   * @param file which
   * @param problems what is wrong
   * @param steps what the change means
   */
  public ConfigChange {
    problems = List.copyOf(problems);
    steps = List.copyOf(steps);
  }
}
