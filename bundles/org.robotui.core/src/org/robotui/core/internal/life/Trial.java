package org.robotui.core.internal.life;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.BiFunction;
import org.robotui.api.host.Exchange;
import org.robotui.api.host.ExchangeOutcome;
import org.robotui.api.host.ExchangePreview;
import org.robotui.api.host.ExchangePreview.Verdict;
import org.robotui.api.port.SourceId;
import org.robotui.core.internal.config.model.CheckedSettings;
import org.robotui.core.internal.config.model.ComponentConfig;
import org.robotui.core.internal.time.RuicClock;
import org.robotui.core.internal.time.RuicFrames;

/** A robot interface on trial: it runs with a clock and frames of its own, nobody hears of its failures, and nothing is wired to it. */
final class Trial implements Exchange {
  private static final Duration CLOSE_LIMIT = Duration.ofSeconds(2);

  private final ComponentConfig wanted;
  private final RficSlot slot;
  private final Preview previews;
  private final SerialWorker worker;
  private final Map<SourceId, SourceId> picked = new ConcurrentHashMap<>();
  private final BiFunction<ComponentConfig, Map<SourceId, SourceId>, CompletionStage<ExchangeOutcome>> exchange;

  /**
   * Starts it.
   *
   * @param ruic the RUIC that it is tried for
   * @param wanted how it is configured
   * @param exchange exchanges, on the worker of the RUIC
   */
  Trial(RuicParts ruic, Components components, Wiring wiring, ComponentConfig wanted,
      BiFunction<ComponentConfig, Map<SourceId, SourceId>, CompletionStage<ExchangeOutcome>> exchange) {
    this.wanted = wanted;
    this.exchange = exchange;
    this.slot = new RficSlot(wanted, alone(ruic));
    this.previews = new Preview(ruic, components, wiring, slot);
    this.worker = new SerialWorker("trial-" + ruic.config().name() + "." + wanted.id());
    worker.execute(slot::start);
  }

  private RuicParts alone(RuicParts ruic) {
    RuicClock clock = new RuicClock(ruic.services().clock(), ruic.services().wall(), () -> { });
    return new RuicParts(ruic.configNow(), ruic.view(), ruic.services().with(new Quiet()), ruic.serial(), ruic.threads(), clock,
        new RuicFrames(List.of()), ruic.alerts(), ruic.overlay(), new Untold());
  }

  @Override
  public ExchangePreview preview() {
    Optional<String> wrong = wrongSettings();
    return previews.of(picked, wrong);
  }

  private Optional<String> wrongSettings() {
    return slot.find()
        .map(type -> slot.ruic().services().check().check(type.schema(), wanted.raw()))
        .filter(CheckedSettings.Invalid.class::isInstance)
        .map(i -> Preview.sentences(((CheckedSettings.Invalid) i).problems()));
  }

  @Override
  public void choose(SourceId port, SourceId peer) {
    picked.put(port, peer);
  }

  @Override
  public CompletionStage<ExchangeOutcome> apply(boolean goWithout) {
    ExchangePreview now = preview();
    boolean allowed = now.verdict() == Verdict.READY || goWithout && now.verdict() != Verdict.FAILED;
    if (!allowed) {
      return CompletableFuture.completedFuture(new ExchangeOutcome.Refused(now.sentence()));
    }
    Map<SourceId, SourceId> connections = previews.chosen(picked);
    CompletableFuture<ExchangeOutcome> done = new CompletableFuture<>();
    // The robot sees one client less before it sees the one that stays.
    worker.execute(() -> {
      slot.close(CLOSE_LIMIT);
      exchange.apply(wanted, connections).thenAccept(done::complete);
    });
    worker.close();
    return done;
  }

  @Override
  public void close() {
    worker.execute(() -> slot.close(CLOSE_LIMIT));
    worker.close();
  }

  /** What happens to something that only is tried is in its preview. */
  private static final class Quiet implements Events {
    @Override
    public void changed(String ruic) {
      // asked for
    }

    @Override
    public void frameReady(String ruic, String uic) {
      // there are no views
    }

    @Override
    public void showWanted(String from, String wanted) {
      // there are no views
    }

    @Override
    public void alert(String ruic, String message) {
      // in the preview
    }

    @Override
    public void removed(RuicRuntime ruic) {
      // cannot happen
    }
  }

  /** Nothing is wired, so nothing has to be done. */
  private final class Untold implements RuicParts.Wake {
    @Override
    public void rematch() {
      // previews match when they are asked for
    }

    @Override
    public void linkChanged() {
      // in the preview
    }

    @Override
    public void failed(Object instance, String reason) {
      worker.execute(() -> slot.giveUp(reason));
    }
  }
}
