package org.robotui.headless.internal;

import java.io.PrintStream;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.robotui.api.host.ConfigChange;
import org.robotui.api.host.ConfigChange.Step;
import org.robotui.api.host.Exchange;
import org.robotui.api.host.ExchangeOutcome;
import org.robotui.api.host.ExchangePreview;
import org.robotui.api.host.ExchangePreview.Verdict;
import org.robotui.api.host.Host;
import org.robotui.api.host.HostListener;
import org.robotui.api.host.Problem;
import org.robotui.api.host.Ruic;

/**
 * Takes up what is changed in the files of configurations, and says what came of it. Another robot interface is tried
 * first; it is exchanged only where it covers all that is used.
 */
final class WatchedFiles implements AutoCloseable {
  /** How long a robot may take to say what it has. */
  private static final Duration TRIAL_LIMIT = Duration.ofSeconds(20);
  private static final Duration LOOK = Duration.ofMillis(100);
  private static final Duration EXCHANGE_LIMIT = Duration.ofSeconds(30);

  private final Host host;
  private final PrintStream err;
  private final BlockingQueue<ConfigChange> changes = new LinkedBlockingQueue<>();
  private final Host.Subscription subscription;
  private final Thread worker;

  WatchedFiles(Host host, PrintStream err) {
    this.host = host;
    this.err = err;
    subscription = host.listen(new HostListener() {
      @Override
      public void configurationChanged(ConfigChange change) {
        changes.add(change);
      }
    });
    worker = Thread.ofPlatform().daemon().name("robotui-watch").start(this::run);
  }

  private void run() {
    try {
      while (!Thread.currentThread().isInterrupted()) {
        take(changes.take());
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt(); // closed
    }
  }

  private void take(ConfigChange change) throws InterruptedException {
    change.problems().forEach(p -> err.println(CheckPrinter.line(p)));
    if (change.problems().stream().anyMatch(p -> p.severity() == Problem.Severity.ERROR)) {
      err.println(change.file() + ": what runs goes on as it was");
    }
    for (Step step : change.steps()) {
      switch (step) {
        case Step.Exchanged e -> exchange(change, e);
        case Step.NeedsRestart r -> restart(r);
        case Step.TakenUp t -> err.println(t.ruic() + ": " + t.what() + " taken up");
        case Step.Added a -> err.println(a.ruic() + ": started");
        case Step.Gone g -> err.println(g.ruic() + ": not in the file any more; it goes on until the end");
      }
    }
  }

  private void restart(Step.NeedsRestart step) {
    for (Ruic ruic : host.ruics()) {
      if (ruic.name().equals(step.ruic())) {
        ruic.restart();
        err.println(step.ruic() + ": restarted, as " + step.what() + " changed");
      }
    }
  }

  private void exchange(ConfigChange change, Step.Exchanged step) throws InterruptedException {
    for (Ruic ruic : host.ruics()) {
      if (ruic.name().equals(step.ruic())) {
        try (Exchange exchange = ruic.exchange(step.wanted())) {
          ExchangePreview preview = await(exchange);
          lines(step, preview).forEach(err::println);
          err.println(outcome(step, exchange, preview));
        } catch (IllegalArgumentException e) {
          err.println(change.file() + ": " + e.getMessage());
        }
      }
    }
  }

  private static ExchangePreview await(Exchange exchange) throws InterruptedException {
    long end = System.nanoTime() + TRIAL_LIMIT.toNanos();
    while (exchange.preview().verdict() == Verdict.PENDING && System.nanoTime() < end) {
      Thread.sleep(LOOK);
    }
    return exchange.preview();
  }

  static List<String> lines(Step.Exchanged step, ExchangePreview preview) {
    return preview.lines().stream().filter(ExchangePreview.Line::concerned)
        .map(l -> String.format(Locale.ROOT, "  %-9s  %s: %s -> %s - %s",
            l.lost() ? "lost" : CheckPrinter.word(l.then().state()),
            l.then().port(), CheckPrinter.names(l.now().peers()), CheckPrinter.names(l.then().peers()),
            l.then().reason()))
        .toList();
  }

  private static String outcome(Step.Exchanged step, Exchange exchange, ExchangePreview preview)
      throws InterruptedException {
    String what = step.ruic() + "." + step.wanted().id() + " as " + step.wanted().type();
    if (preview.verdict() != Verdict.READY) {
      return what + ": not exchanged: " + preview.sentence() + "; what runs goes on as it was";
    }
    try {
      return switch (exchange.apply(false).toCompletableFuture().get(EXCHANGE_LIMIT.toMillis(),
          TimeUnit.MILLISECONDS)) {
        case ExchangeOutcome.Done d -> what + ": exchanged";
        case ExchangeOutcome.Refused r -> what + ": not exchanged: " + r.reason();
        case ExchangeOutcome.WentBack w -> what + ": went back: " + w.reason();
      };
    } catch (ExecutionException | TimeoutException e) {
      return what + ": no outcome: " + e;
    }
  }

  @Override
  public void close() {
    subscription.close();
    worker.interrupt();
  }
}
