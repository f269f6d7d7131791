package org.robotui.headless.internal;

import java.nio.file.Path;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.robotui.api.UicType.Surface;
import org.robotui.api.command.Principal;
import org.robotui.api.host.CheckReport;
import org.robotui.api.host.Host;
import org.robotui.api.host.Match;
import org.robotui.api.host.MatchState;
import org.robotui.api.host.Problem;
import org.robotui.api.host.Ruic;

/**
 * Checks a configuration against its running robots, since most of them say only then what they have. It connects as
 * the workbench would, takes no lease and sends nothing.
 */
final class LiveCheck {
  private static final Principal NOBODY = new Principal("check", "Check", Principal.Kind.SCRIPT);
  private static final Duration LOOK = Duration.ofMillis(100);
  private static final Duration CLOSE_LIMIT = Duration.ofMillis(1800);

  private final Host host;

  LiveCheck(Host host) {
    this.host = host;
  }

  /** Waits until nothing is pending any more, or the time is over. */
  CheckReport check(Path file, Duration limit) throws InterruptedException {
    host.open(Surface.WINDOW, NOBODY);
    try {
      List<Problem> problems = host.load(file);
      long end = System.nanoTime() + limit.toNanos();
      while (pending() && System.nanoTime() < end) {
        Thread.sleep(LOOK);
      }
      return new CheckReport(problems, matches(), host.reuse());
    } finally {
      host.close(CLOSE_LIMIT);
    }
  }

  private boolean pending() {
    return matches().values().stream().flatMap(List::stream).anyMatch(m -> m.state() == MatchState.PENDING)
        || matches().values().stream().anyMatch(List::isEmpty);
  }

  private Map<String, List<Match>> matches() {
    Map<String, List<Match>> matches = new LinkedHashMap<>();
    for (Ruic ruic : host.ruics()) {
      matches.put(ruic.name(), ruic.snapshot().matches());
    }
    return matches;
  }
}
