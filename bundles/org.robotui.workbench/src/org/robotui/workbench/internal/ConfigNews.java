package org.robotui.workbench.internal;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import org.robotui.api.host.ConfigChange;
import org.robotui.api.host.ConfigChange.Step;
import org.robotui.api.host.Problem;

/** What to say of a change of a configuration file. */
final class ConfigNews {
  private ConfigNews() {}

  /**
   * What stays to be read above the views.
   *
   * @param change the change
   * @param asked whether the user is asked about a RUIC in its window
   */
  static List<Problem> problems(ConfigChange change, Predicate<String> asked) {
    List<Problem> all = new ArrayList<>(change.problems());
    change.steps().forEach(step -> warning(step, asked)
        .ifPresent(words -> all.add(new Problem(change.file().toString(), 0, 0, Problem.Severity.WARNING, words))));
    return all;
  }

  private static Optional<String> warning(Step step, Predicate<String> asked) {
    return switch (step) {
      case Step.Exchanged e when !asked.test(e.ruic()) -> Optional
          .of(e.ruic() + ": the robot interface '" + e.wanted().id()
              + "' was changed; select it and choose Robot > Change Framework, or restart it, to take that up");
      case Step.NeedsRestart r -> Optional
          .of(r.ruic() + ": " + r.what() + " changed; choose Robot > Restart Robot UI to take that up");
      case Step.Gone g -> Optional.of(g.ruic() + " is not in the file any more; it goes on until it is removed");
      default -> Optional.empty();
    };
  }

  /** What is said in passing, empty for nothing. */
  static String notice(ConfigChange change) {
    List<String> words = new ArrayList<>();
    for (Step step : change.steps()) {
      switch (step) {
        case Step.TakenUp t -> words.add(t.ruic() + ": " + t.what() + " taken up from the file");
        case Step.Added a -> words.add(a.ruic() + " is new in the file");
        default -> {}
      }
    }
    return String.join("; ", words);
  }
}
