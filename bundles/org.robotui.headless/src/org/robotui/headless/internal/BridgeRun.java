package org.robotui.headless.internal;

import java.io.IOException;
import java.io.PrintStream;
import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.robotui.api.bridge.BridgeStatus;
import org.robotui.api.bridge.Bridges;
import org.robotui.api.host.Host;

/** Runs bridges until it is stopped or the time is over, and says how they are doing. */
final class BridgeRun {
  private static final long LINE_MILLIS = 1000;
  /** Lines of text are for people: where nothing changes they come seldom. */
  private static final int SELDOM = 10;

  private final Host host;
  private final Bridges bridges;
  private final PrintStream out;
  private final PrintStream err;
  private final CountDownLatch stop;
  private final Map<String, String> told = new HashMap<>();

  BridgeRun(Host host, Bridges bridges, PrintStream out, PrintStream err, CountDownLatch stop) {
    this.host = host;
    this.bridges = bridges;
    this.out = out;
    this.err = err;
    this.stop = stop;
  }

  /** Answers how it ended. */
  Exit run(BridgeArguments wanted) throws InterruptedException {
    if (host.bridges().isEmpty()) {
      err.println("the configurations have no bridge that could run; write them as 'bridges' (docs/bridges.md)");
      return Exit.BRIDGE;
    }
    bridges.start();
    try {
      return wanted.metricsPort().isPresent() ? measured(wanted, wanted.metricsPort().getAsInt()) : told(wanted);
    } finally {
      bridges.stop();
    }
  }

  private Exit measured(BridgeArguments wanted, int port) throws InterruptedException {
    try (MetricsDoor door = MetricsDoor.open(port, () -> BridgeMetrics.text(bridges.statuses()))) {
      err.println("the numbers of the bridges are at " + door.address());
      return told(wanted);
    } catch (IOException e) {
      err.println("the numbers of the bridges cannot be given at port " + port + ": " + e.getMessage()
          + "; give another port, or 0 for any");
      return Exit.BRIDGE;
    }
  }

  private Exit told(BridgeArguments wanted) throws InterruptedException {
    boolean json = wanted.rest().json();
    Optional<Duration> limit = wanted.rest().limit();
    long begun = System.nanoTime();
    for (long second = 0; limit.filter(most -> System.nanoTime() - begun >= most.toNanos()).isEmpty(); second++) {
      if (stop.await(LINE_MILLIS, TimeUnit.MILLISECONDS)) {
        break;
      }
      List<BridgeStatus> statuses = bridges.statuses();
      if (json) {
        statuses.forEach(status -> out.println(json(status)));
      } else {
        boolean all = second % SELDOM == 0;
        statuses.stream().filter(status -> changed(status) || all).forEach(status -> out.println(text(status)));
      }
      out.flush();
    }
    return Exit.FINE;
  }

  private boolean changed(BridgeStatus status) {
    String now = status.state() + status.text();
    return !now.equals(told.put(status.name() + status.to(), now));
  }

  static String text(BridgeStatus status) {
    BridgeStatus.Counts counts = status.counts();
    String lag = Double.isFinite(status.lagSeconds()) ? String.format(Locale.ROOT, "%.1f ms", status.lagSeconds() * 1e3)
        : "-";
    return String.format(Locale.ROOT,
        "%-12s %s -> %s  %.1f Hz, lag %s, %d passed, %d thinned, %d dropped, %d refused  %s%s%s",
        status.name(), status.from(), status.to(), status.rateHz(), lag, counts.passed(), counts.thinned(),
        counts.dropped(), counts.refused(), word(status),
        status.state() == BridgeStatus.State.CARRYING ? "" : ": " + status.text(),
        status.holder().map(who -> " (control: " + who + ")").orElse(""));
  }

  static String json(BridgeStatus status) {
    BridgeStatus.Counts counts = status.counts();
    return new Json()
        .put("bridge", status.name())
        .put("from", status.from().toString())
        .put("to", status.to().toString())
        .put("state", word(status))
        .put("text", status.text())
        .put("rate_hz", status.rateHz(), 2)
        .put("lag_s", status.lagSeconds(), 6)
        .put("received", counts.received())
        .put("passed", counts.passed())
        .put("thinned", counts.thinned())
        .put("dropped", counts.dropped())
        .put("refused", counts.refused())
        .put("control", status.holder().orElse(""))
        .end();
  }

  private static String word(BridgeStatus status) {
    return status.state().name().toLowerCase(Locale.ROOT);
  }
}
