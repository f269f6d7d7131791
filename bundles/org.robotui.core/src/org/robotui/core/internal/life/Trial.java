package org.robotui.core.internal.life;

import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.BiFunction;
import org.robotui.api.host.Exchange;
import org.robotui.api.host.ExchangeOutcome;
import org.robotui.api.host.ExchangePreview;
import org.robotui.api.host.ExchangePreview.Verdict;
import org.robotui.api.port.SourceId;
import org.robotui.core.internal.config.model.ComponentConfig;

/** A robot interface on trial for the place of one that runs. */
final class Trial implements Exchange {
  private final LoneInterface tried;
  private final Preview previews;
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
    this.exchange = exchange;
    this.tried = new LoneInterface(wanted, ruic.config().name(), ruic.services());
    this.previews = new Preview(ruic, components, wiring, tried.slot());
  }

  @Override
  public ExchangePreview preview() {
    return previews.of(picked, tried.failure());
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
    tried.closeThen(() -> exchange.apply(tried.wanted(), connections).thenAccept(done::complete));
    return done;
  }

  @Override
  public void close() {
    tried.close();
  }
}
