package org.robotui.testkit.host;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.CopyOnWriteArrayList;
import org.robotui.api.host.Exchange;
import org.robotui.api.host.ExchangeOutcome;
import org.robotui.api.host.ExchangePreview;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.SourceId;

/** A trial that says what a test sets, and notes down what is asked of it. Safe for all threads. */
public final class FakeExchange implements Exchange {
  private final List<String> calls = new CopyOnWriteArrayList<>();
  private volatile ExchangePreview preview = new ExchangePreview(ExchangePreview.Verdict.PENDING, "base is connecting",
      new LinkState.Connecting("robot"), List.of(), List.of(), List.of());
  private volatile ExchangeOutcome outcome = new ExchangeOutcome.Done();

  /**
   * Sets what it says.
   *
   * @param value the preview
   * @return this
   */
  public FakeExchange saying(ExchangePreview value) {
    preview = value;
    return this;
  }

  /**
   * Sets what comes of it.
   *
   * @param value the outcome
   * @return this
   */
  public FakeExchange ending(ExchangeOutcome value) {
    outcome = value;
    return this;
  }

  /**
   * What was asked of it, in order, for example {@code apply false}.
   *
   * @return the calls
   */
  public List<String> calls() {
    return List.copyOf(calls);
  }

  @Override
  public ExchangePreview preview() {
    return preview;
  }

  @Override
  public void choose(SourceId port, SourceId peer) {
    calls.add("choose " + port + " " + peer);
  }

  @Override
  public CompletionStage<ExchangeOutcome> apply(boolean goWithout) {
    calls.add("apply " + goWithout);
    return CompletableFuture.completedFuture(outcome);
  }

  @Override
  public void close() {
    calls.add("close");
  }
}
