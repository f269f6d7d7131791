package org.robotui.core.internal.compose;

import java.nio.file.Path;
import java.time.Duration;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.robotui.api.RficType;
import org.robotui.api.host.CompositionState;
import org.robotui.api.host.CompositionState.Stage;
import org.robotui.api.host.CompositionText;
import org.robotui.api.host.InterfaceConfig;
import org.robotui.api.host.PortStatus;
import org.robotui.api.host.RuicDraft;
import org.robotui.api.host.RuicFit;
import org.robotui.api.host.RuicView;
import org.robotui.api.host.ViewFit;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.SourceId;
import org.robotui.core.internal.config.model.ConfigSource;
import org.robotui.core.internal.life.Services;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A file that is tried: what it has says which views are chosen.
 *
 * @param services of the host
 * @param configs reads configurations
 * @param type opens it
 * @param file its absolute path
 * @param ending of its name, by which the type opens it; none for a folder
 */
record FileTrial(Services services, ConfigSource configs, RficType type, Path file, String ending) {
  private static final Logger LOG = LoggerFactory.getLogger(FileTrial.class);
  /** A large file without an index is read through before anything is known of it. */
  private static final Duration PATIENCE = Duration.ofMinutes(10);
  private static final Duration LOOK = Duration.ofMillis(100);
  /** A file has all that it has at once, and tells it one after the other. */
  private static final long CALM_NANOS = Duration.ofMillis(500).toNanos();
  private static final Duration END = Duration.ofSeconds(3);
  private static final int LONGEST_NAME = 50;

  /** Writes the configuration; answers why that cannot be. */
  Optional<String> write(Path configuration) throws InterruptedException {
    String name = name();
    InterfaceConfig wanted = new InterfaceConfig(type.id(), type.id(), name, "",
        Map.of(type.files().orElseThrow().setting(), file.toString()));
    Composing trial = new Composing(wanted, services, configs);
    try {
      return write(trial, await(trial), name, configuration);
    } finally {
      end(trial);
    }
  }

  private Optional<String> write(Composing trial, CompositionState state, String name, Path configuration) {
    if (!state.usable()) {
      return Optional.of(file + " cannot be opened: " + reason(state));
    }
    // Where no view for a window is installed, what has no surface or that of a terminal is in the plainest type, too.
    boolean terminal = state.views().isEmpty();
    Optional<RuicFit> ruic = terminal ? state.ruics().stream().min(Comparator.comparingInt(r -> r.views().size()))
        : state.ruics().stream().findFirst();
    if (ruic.isEmpty() || !terminal && state.views().stream().noneMatch(ViewFit::fits)) {
      return Optional.of(file + " has nothing that a view which is installed could show");
    }
    List<String> views = terminal ? ruic.get().views() : views(state, ruic.get());
    RuicDraft draft =
        new RuicDraft(name, ruic.get().type(), views, state.proposedConnections(views), configuration);
    CompositionText text = trial.text(draft);
    if (text instanceof CompositionText.Text ready) {
      text = trial.write(draft, ready);
    }
    return text instanceof CompositionText.Refused refused ? Optional.of(file + ": " + refused.reason())
        : Optional.empty();
  }

  /** Of a layout that brings none of those that fit, what fits is shown all the same. */
  private static List<String> views(CompositionState state, RuicFit ruic) {
    List<String> proposed = state.proposedViews(ruic.type());
    return proposed.isEmpty() ? state.views().stream().filter(ViewFit::fits).map(ViewFit::type).toList() : proposed;
  }

  private static String reason(CompositionState state) {
    return state.link() instanceof LinkState.Failed failed ? failed.reason() : state.sentence();
  }

  private CompositionState await(Composing trial) throws InterruptedException {
    long end = System.nanoTime() + PATIENCE.toNanos();
    long news = System.nanoTime();
    List<SourceId> ports = List.of();
    CompositionState state = trial.state();
    while (!isDecided(state, System.nanoTime() - news) && System.nanoTime() < end) {
      Thread.sleep(LOOK);
      state = trial.state();
      List<SourceId> now = state.ports().stream().map(PortStatus::port).toList();
      if (!now.equals(ports)) {
        ports = now;
        news = System.nanoTime();
      }
    }
    return state;
  }

  private static boolean isDecided(CompositionState state, long calm) {
    return state.stage() == Stage.FAILED || state.stage() == Stage.FOUND || state.stage() == Stage.KNOWN
        || state.link() instanceof LinkState.Failed
        || state.stage() == Stage.LOOKING && !state.ports().isEmpty() && calm > CALM_NANOS;
  }

  /** The file is not read twice at once: what plays it is a thing of its own with a time of its own. */
  private static void end(Composing trial) throws InterruptedException {
    try {
      trial.end().get(END.toMillis(), TimeUnit.MILLISECONDS);
    } catch (ExecutionException | TimeoutException e) {
      LOG.warn("what has tried a file has not ended in time", e);
    }
  }

  /** The name of the file, as far as a name may have its characters, and none that runs. */
  private String name() {
    String plain = file.getFileName().toString();
    String words = plain.substring(0, plain.length() - ending.length()).replaceAll("[\\p{Cntrl}/${}]", "_")
        .strip();
    String cut = words.isEmpty() ? type.label() : words.substring(0, Math.min(LONGEST_NAME, words.length())).strip();
    List<String> taken = services.ruics().get().stream().map(RuicView::name).toList();
    String name = cut;
    for (int number = 2; taken.contains(name); number++) {
      name = cut + " " + number;
    }
    return name;
  }
}
