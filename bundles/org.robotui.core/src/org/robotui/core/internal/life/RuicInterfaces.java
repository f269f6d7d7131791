package org.robotui.core.internal.life;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BiFunction;
import org.robotui.api.host.ConfigChange;
import org.robotui.api.host.Exchange;
import org.robotui.api.host.ExchangeOutcome;
import org.robotui.api.host.InterfaceConfig;
import org.robotui.api.port.SourceId;
import org.robotui.core.internal.config.model.ComponentConfig;
import org.robotui.core.internal.config.model.RuicConfig;

/** How the robot interfaces of one RUIC are configured: in its file, and as the user has exchanged them since. */
final class RuicInterfaces {
  private final RuicParts ruic;
  private final Written written;
  private final AtomicReference<RuicConfig> config;
  private final AtomicReference<RuicConfig> file;
  private final Components components;
  private final RuicRobots robots;
  private final Wiring wiring;

  /**
   * Of a RUIC.
   *
   * @param config as it runs
   * @param file as it is written
   */
  RuicInterfaces(RuicParts ruic, AtomicReference<RuicConfig> config, AtomicReference<RuicConfig> file,
      Components components,
      RuicRobots robots, Wiring wiring) {
    this.ruic = ruic;
    this.written = new Written(ruic.services().check());
    this.config = config;
    this.file = file;
    this.components = components;
    this.robots = robots;
    this.wiring = wiring;
  }

  List<InterfaceConfig> all() {
    return config.get().rfics().stream().map(written::show).toList();
  }

  /** As in the file, where it runs otherwise. */
  Optional<InterfaceConfig> inFile(String id) {
    return file.get().rfic(id).filter(c -> config.get().rfic(id).filter(now -> !written.same(now, c)).isPresent())
        .map(written::show);
  }

  /** Tries one; {@code exchange} has {@link #exchange} called on the worker. */
  Exchange trial(
      InterfaceConfig wanted,
      BiFunction<ComponentConfig, Map<SourceId, SourceId>, CompletionStage<ExchangeOutcome>> exchange) {
    ComponentConfig at = config.get().rfic(wanted.id()).orElseThrow(
        () -> new IllegalArgumentException(config.get().name() + " has no robot interface '" + wanted.id() + "'"));
    return new Trial(ruic, components, wiring, written.place(wanted, at), exchange);
  }

  /** Exchanges, and keeps it. On the worker. */
  ExchangeOutcome exchange(ComponentConfig next, Map<SourceId, SourceId> connections) {
    ExchangeOutcome outcome = new Exchanger(ruic, config, components, robots, wiring).exchange(next, connections);
    if (outcome instanceof ExchangeOutcome.Done) {
      file.get().rfic(next.id()).filter(c -> !written.same(c, next)).ifPresentOrElse(
          c -> ruic.overlay().put(next.id(), written.keep(next, c)), () -> ruic.overlay().forgetInterface(next.id()));
    }
    return outcome;
  }

  /** The file says something else: what can be taken up while it runs is, and the rest is for {@link #takeUpFile}. */
  List<ConfigChange.Step> fileChanged(RuicConfig latest) {
    RuicDiff diff = new RuicDiff(written, file.getAndSet(latest), latest);
    if (!diff.live().isEmpty()) {
      config.updateAndGet(c -> c.withLiveParts(latest));
      robots.recheck();
      wiring.request();
    }
    return diff.steps();
  }

  /** All that the file says now holds, but for what the user has exchanged. On the worker, while no component runs. */
  void takeUpFile() {
    config.set(written.withChosen(file.get(), ruic.overlay()));
    ruic.frames().configure(config.get().frames());
    robots.register();
  }
}
