package org.robotui.headless.internal;

import java.io.PrintStream;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.UicType.Surface;
import org.robotui.api.command.Principal;
import org.robotui.api.config.Schema;
import org.robotui.api.config.ValueType;
import org.robotui.api.host.Composition;
import org.robotui.api.host.CompositionState;
import org.robotui.api.host.CompositionState.Stage;
import org.robotui.api.host.CompositionText;
import org.robotui.api.host.Host;
import org.robotui.api.host.Installed;
import org.robotui.api.host.InterfaceConfig;
import org.robotui.api.host.Match;
import org.robotui.api.host.RuicDraft;
import org.robotui.api.host.RuicFit;
import org.robotui.api.host.ViewFit;
import org.robotui.api.port.SourceId;

/** Writes the configuration of a robot from what it offers, and says what was chosen and why. */
final class NewRun {
  private static final Principal NOBODY = new Principal("new", "New robot UI", Principal.Kind.SCRIPT);
  private static final String ID = "base";
  private static final Duration LOOK = Duration.ofMillis(100);
  /** Types of components may still be on their way when the application starts. */
  private static final Duration TYPES = Duration.ofSeconds(5);
  private static final Duration CLOSE_LIMIT = Duration.ofMillis(1800);

  private final Host host;
  private final PrintStream out;
  private final PrintStream err;

  NewRun(Host host, PrintStream out, PrintStream err) {
    this.host = host;
    this.out = out;
    this.err = err;
  }

  Exit run(NewArguments wanted) throws InterruptedException {
    host.open(Surface.WINDOW, NOBODY);
    try {
      Optional<Installed> type = type(wanted.rfic());
      if (type.isEmpty()) {
        return wrong("there is no robot interface '" + wanted.rfic() + "'; there are "
            + String.join(", ", ids(Installed.Kind.RFIC)));
      }
      Map<String, Object> settings = settings(wanted.settings(), type.get().descriptor().schema());
      try (Composition composition =
          host.compose(new InterfaceConfig(ID, wanted.rfic(), wanted.robot(), "", settings))) {
        return run(wanted, composition, await(composition, wanted.patience()));
      }
    } finally {
      host.close(CLOSE_LIMIT);
    }
  }

  private Exit run(NewArguments wanted, Composition composition, CompositionState state) {
    if (!state.usable()) {
      return wrong(wanted.rfic() + ": " + state.sentence());
    }
    out.println(wanted.rfic() + ": " + state.sentence());
    Optional<RuicFit> ruic =
        wanted.ruic().isPresent() ? wanted.ruic().flatMap(state::ruic) : state.ruics().stream().findFirst();
    if (ruic.isEmpty()) {
      return wrong("there is no robot UI '" + wanted.ruic().orElse("") + "'; there are "
          + String.join(", ", ids(Installed.Kind.RUIC)));
    }
    out.println("type " + ruic.get().type() + ": " + ruic.get().reason());
    List<String> views = wanted.views().orElseGet(() -> state.proposedViews(ruic.get().type()));
    Optional<String> unknown = views.stream().filter(v -> state.view(v).isEmpty()).findFirst();
    if (unknown.isPresent()) {
      return wrong("there is no view '" + unknown.get() + "'; there are "
          + String.join(", ", state.views().stream().map(ViewFit::type).sorted().toList()));
    }
    Map<SourceId, SourceId> connections = state.proposedConnections(views);
    List<String> mistakes = choose(wanted.connections(), state, views, connections);
    if (!mistakes.isEmpty()) {
      return wrong(String.join("\n", mistakes));
    }
    tell(state, ruic.get(), views, connections);
    return write(wanted, composition,
        new RuicDraft(wanted.name(), ruic.get().type(), views, connections, wanted.file()));
  }

  private static List<String> choose(Map<String, String> wanted, CompositionState state, List<String> views,
      Map<SourceId, SourceId> connections) {
    List<String> mistakes = new ArrayList<>();
    wanted.forEach((text, peer) -> {
      Optional<Match> match =
          state.views().stream().filter(v -> views.contains(v.type())).flatMap(v -> v.matches().stream())
              .filter(m -> m.port().toString().equals(text)).findFirst();
      Optional<SourceId> chosen = state.ports().stream().map(p -> p.port())
          .filter(p -> p.toString().equals(peer) || p.port().equals(peer)).findFirst();
      if (match.isEmpty()) {
        mistakes.add("there is no port '" + text + "' of a chosen view; write view.port");
      } else if (chosen.isEmpty()) {
        mistakes.add("the robot has no port '" + peer + "'" + (match.get().candidates().isEmpty() ? ""
            : "; what fits " + text + " is " + CheckPrinter.names(match.get().candidates())));
      } else {
        connections.put(match.get().port(), chosen.get());
      }
    });
    return mistakes;
  }

  private void tell(CompositionState state, RuicFit ruic, List<String> views, Map<SourceId, SourceId> connections) {
    for (ViewFit view : state.views()) {
      boolean shown = views.contains(view.type());
      if (shown || view.fits() || ruic.views().contains(view.type())) {
        out.println("  " + (shown ? "+ " : "- ") + view.type() + ": " + view.reason()
            + (!shown && view.fits() ? " (not part of " + ruic.type() + ")" : ""));
      }
    }
    connections.forEach((port, peer) -> out.println("  " + port + " <-> " + peer + others(state, port, peer)));
  }

  private static String others(CompositionState state, SourceId port, SourceId peer) {
    List<SourceId> others = state.views().stream().flatMap(v -> v.choices().stream()).filter(m -> m.port().equals(port))
        .flatMap(m -> m.candidates().stream()).filter(c -> !c.equals(peer)).toList();
    return others.isEmpty() ? ""
        : "; also fits: " + CheckPrinter.names(others) + " (--connect " + port + "=" + others.getFirst().port() + ")";
  }

  private Exit write(NewArguments wanted, Composition composition, RuicDraft draft) {
    CompositionText text = composition.text(draft);
    if (text instanceof CompositionText.Text ready && !wanted.dry()) {
      text = composition.write(draft, ready);
    }
    return switch (text) {
      case CompositionText.Refused r -> wrong(r.reason());
      case CompositionText.Text t -> {
        String done = wanted.dry() ? "would be written to " : t.isNew() ? "written: " : "added to ";
        out.println(done + t.file() + (t.isNew() ? "" : ", line " + t.line()));
        out.print(t.added());
        yield Exit.FINE;
      }
    };
  }

  /** What can only be a list is one. */
  private static Map<String, Object> settings(Map<String, String> given, Schema schema) {
    Map<String, Object> settings = new LinkedHashMap<>();
    given.forEach((name, text) -> settings.put(name,
        schema.find(name).filter(s -> s.type() instanceof ValueType.ListOf).isPresent()
            ? List.of(text.split("\\s*,\\s*"))
            : text));
    return settings;
  }

  private Optional<Installed> type(String rfic) throws InterruptedException {
    long end = System.nanoTime() + TYPES.toNanos();
    Optional<Installed> found = find(rfic);
    while ((found.isEmpty() || ids(Installed.Kind.RUIC).isEmpty()) && System.nanoTime() < end) {
      Thread.sleep(LOOK);
      found = find(rfic);
    }
    return found;
  }

  private Optional<Installed> find(String rfic) {
    return host.installed().stream().filter(t -> t.kind() == Installed.Kind.RFIC && t.descriptor().id().equals(rfic))
        .findFirst();
  }

  private List<String> ids(Installed.Kind kind) {
    return host.installed().stream().filter(t -> t.kind() == kind).map(t -> t.descriptor().id()).toList();
  }

  /** Until nothing more is to be expected, or the time is over. */
  private static CompositionState await(Composition composition, Duration limit) throws InterruptedException {
    long end = System.nanoTime() + limit.toNanos();
    CompositionState state = composition.state();
    while ((state.stage() == Stage.CONNECTING || state.stage() == Stage.LOOKING || state.stage() == Stage.UNREACHED)
        && System.nanoTime() < end) {
      Thread.sleep(LOOK);
      state = composition.state();
    }
    return state;
  }

  private Exit wrong(String message) {
    err.println(message);
    return Exit.ERRORS;
  }
}
