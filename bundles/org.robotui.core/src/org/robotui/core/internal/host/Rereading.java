package org.robotui.core.internal.host;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.robotui.api.host.ConfigChange;
import org.robotui.api.host.ConfigChange.Step;
import org.robotui.core.internal.config.model.ConfigResult;
import org.robotui.core.internal.config.model.RuicConfig;
import org.robotui.core.internal.life.RuicRuntime;

/** Takes up what became of files that were loaded before. One thread at a time. */
final class Rereading {
  private final Function<String, Optional<RuicRuntime>> running;
  private final Map<Path, Set<String>> known = new HashMap<>();

  /** Finds RUICs that run by their names. */
  Rereading(Function<String, Optional<RuicRuntime>> running) {
    this.running = running;
  }

  /** Forgets which RUICs a file had: those that do not run are started. */
  synchronized void forgetEnded(Path file) {
    known.computeIfPresent(file, (f, names) -> names.stream()
        .filter(n -> running.apply(n).filter(r -> r.isOf(file.toString())).isPresent()).collect(Collectors.toSet()));
  }

  /**
   * It was read, for the first time or again.
   *
   * @param add starts a RUIC that was not in the file before
   */
  synchronized ConfigChange read(Path file, ConfigResult result, Function<RuicConfig, List<Step>> add) {
    Set<String> before = known.getOrDefault(file, Set.of());
    List<Step> steps = new ArrayList<>();
    for (RuicConfig ruic : result.ruics()) {
      Optional<RuicRuntime> runs = running.apply(ruic.name()).filter(r -> r.isOf(ruic.file()));
      steps.addAll(runs.map(r -> r.fileChanged(ruic))
          .orElseGet(() -> before.contains(ruic.name()) ? List.of() : add.apply(ruic)));
    }
    Set<String> now = names(result);
    if (result.problems().isEmpty()) {
      before.stream().filter(n -> !now.contains(n) && running.apply(n).filter(r -> r.isOf(file.toString())).isPresent())
          .sorted().forEach(n -> steps.add(new Step.Gone(n)));
    }
    Set<String> all = new HashSet<>(now);
    all.addAll(result.problems().isEmpty() ? Set.of() : before);
    known.put(file, all);
    return new ConfigChange(file, result.problems(), steps);
  }

  private static Set<String> names(ConfigResult result) {
    Set<String> names = new HashSet<>();
    result.ruics().forEach(r -> names.add(r.name()));
    return names;
  }
}
