package org.robotui.headless.internal;

import java.io.PrintStream;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import org.robotui.api.config.Configuration;
import org.robotui.api.host.CheckReport;
import org.robotui.api.host.Host;

/** Checks one configuration and ends. */
final class CheckRun {
  /** Component types may still be on their way when the application starts. */
  private static final Duration TYPES_LIMIT = Duration.ofSeconds(5);

  private final Host host;
  private final PrintStream out;
  private final PrintStream err;

  CheckRun(Host host, PrintStream out, PrintStream err) {
    this.host = host;
    this.out = out;
    this.err = err;
  }

  Exit check(Path file, Optional<Duration> live, Optional<String> reuse) throws InterruptedException {
    Optional<String> unreadable = Configuration.unreadable(file);
    if (unreadable.isPresent()) {
      err.println(unreadable.get());
      return Exit.UNREADABLE;
    }
    CheckReport report = host.check(file, TYPES_LIMIT);
    if (report.usable() && live.isPresent()) {
      report = new LiveCheck(host).check(file, live.get());
    }
    CheckPrinter printer = new CheckPrinter(out);
    printer.print(report);
    printer.reuse(report.reuse(), reuse);
    return report.usable() ? Exit.FINE : Exit.ERRORS;
  }
}
