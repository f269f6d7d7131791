package org.robotui.core.internal.host;

import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.robotui.api.ComponentType;
import org.robotui.api.host.CheckReport;
import org.robotui.api.host.Match;
import org.robotui.api.host.Problem;
import org.robotui.api.port.Port;
import org.robotui.api.port.SourceId;
import org.robotui.core.internal.config.model.ComponentConfig;
import org.robotui.core.internal.config.model.ConfigResult;
import org.robotui.core.internal.config.model.RuicConfig;
import org.robotui.core.internal.life.Plan;
import org.robotui.core.internal.life.Wiring;
import org.robotui.core.internal.match.Have;
import org.robotui.core.internal.match.Matcher;
import org.robotui.core.internal.match.Supplier;
import org.robotui.core.internal.match.Want;

/** Says what would become of a configuration, without connecting to any robot. */
final class Checker {
  private final CoreParts parts;

  Checker(CoreParts parts) {
    this.parts = parts;
  }

  CheckReport check(Path file, Duration wait) {
    awaitTypes(file, wait);
    ConfigResult result = parts.configs().read(file, parts.registry());
    List<Problem> problems = new ArrayList<>(result.problems());
    Map<String, List<Match>> matches = new LinkedHashMap<>();
    Reuse reuse = new Reuse(parts.registry(), parts.bundles());
    for (RuicConfig ruic : result.ruics()) {
      switch (Plan.of(ruic, parts.registry(), parts.check())) {
        case Plan.Outcome.Made m -> {
          matches.put(ruic.name(), matches(ruic, m.plan()));
          reuse.add(ruic, m.plan());
        }
        case Plan.Outcome.Impossible i -> problems.add(missing(ruic, i.reason()));
      }
    }
    return new CheckReport(List.copyOf(problems), matches, reuse.report());
  }

  private static Problem missing(RuicConfig ruic, String reason) {
    return new Problem(ruic.file(), ruic.line(), ruic.column(), Problem.Severity.WARNING, ruic.name() + ": " + reason);
  }

  private void awaitTypes(Path file, Duration wait) {
    try {
      parts.registry().await(() -> complete(parts.configs().read(file, parts.registry())), wait);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private boolean complete(ConfigResult result) {
    return result.ruics().stream().allMatch(r -> switch (Plan.of(r, parts.registry(), parts.check())) {
      case Plan.Outcome.Made m -> r.rfics().stream().allMatch(c -> rfic(c).isPresent())
          && m.plan().uics().stream().allMatch(c -> uic(c).isPresent());
      case Plan.Outcome.Impossible i -> false;
    });
  }

  private List<Match> matches(RuicConfig ruic, Plan plan) {
    List<Want> wants = plan.uics().stream()
        .flatMap(c -> ports(uic(c)).map(p -> new Want(new SourceId(c.id(), p.name()), p))).toList();
    List<Have> haves = ruic.rfics().stream()
        .flatMap(c -> ports(rfic(c)).map(p -> new Have(new SourceId(c.id(), p.name()), p))).toList();
    List<Supplier> suppliers = ruic.rfics().stream()
        .map(c -> new Supplier(c.id(), false, rfic(c).isPresent()
            ? "will say what it has when it runs"
            : parts.registry().missingRfic(c.type())))
        .toList();
    return Matcher.match(wants, haves, suppliers, Wiring.choices(ruic, Map.of()));
  }

  private static Stream<Port> ports(Optional<? extends ComponentType> type) {
    return type.stream().flatMap(t -> t.ports().stream());
  }

  private Optional<? extends ComponentType> rfic(ComponentConfig component) {
    return parts.registry().rfic(component.type());
  }

  private Optional<? extends ComponentType> uic(ComponentConfig component) {
    return parts.registry().uic(component.type());
  }
}
