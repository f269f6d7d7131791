package org.robotui.headless.internal;

import java.io.PrintStream;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.robotui.api.UicType.Surface;
import org.robotui.api.command.Principal;
import org.robotui.api.config.Configuration;
import org.robotui.api.config.UserFolder;
import org.robotui.api.host.FileOutcome;
import org.robotui.api.host.Host;
import org.robotui.api.host.Problem;
import org.robotui.api.host.Ruic;
import org.robotui.api.script.Scripts;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Loads configurations and shows their robots until it is stopped or the time is over. */
final class ShowRun {
  /** How long the end may take, also when a robot hangs. */
  static final Duration CLOSE_LIMIT = Duration.ofMillis(1800);

  private static final Logger LOG = LoggerFactory.getLogger(ShowRun.class);
  private static final Principal USER = new Principal("terminal", "You", Principal.Kind.TERMINAL);

  private final Host host;
  private final PrintStream out;
  private final PrintStream err;
  private final CountDownLatch stop;
  private final Optional<Scripts> scripts;

  ShowRun(Host host, PrintStream out, PrintStream err, CountDownLatch stop, Optional<Scripts> scripts) {
    this.scripts = scripts;
    this.host = host;
    this.out = out;
    this.err = err;
    this.stop = stop;
  }

  /** What is done in place of showing robots; answers the exit code. */
  @FunctionalInterface
  interface Occupation {
    /** Ends when it is done, or when it is stopped. */
    int run() throws InterruptedException;
  }

  /** Answers the exit code. */
  int show(Arguments arguments) throws InterruptedException {
    return show(arguments, Optional.empty());
  }

  /** The same, where something else is done than showing them. */
  int show(Arguments arguments, Optional<Occupation> instead) throws InterruptedException {
    host.open(Surface.TEXT, USER);
    try (Selector ignored = new Selector(host, arguments.shown())) {
      Exit configured = load(arguments.configurations());
      Exit opened = open(arguments.files());
      Exit loaded = configured == Exit.FINE ? opened : configured;
      sayWhatIsLeftOut(arguments.shown());
      return loaded == Exit.FINE || !host.ruics().isEmpty() ? withDoor(arguments, loaded, instead)
          : loaded.code();
    } finally {
      host.close(CLOSE_LIMIT).forEach(left -> LOG.warn("not ended in time: {}", left));
    }
  }

  private int withDoor(Arguments arguments, Exit loaded, Optional<Occupation> instead) throws InterruptedException {
    Optional<Scripts.Door> door =
        scripts.filter(s -> arguments.scriptSocket()).flatMap(s -> s.listen(
            UserFolder.sockets(UserFolder.state(System.getProperties(), System.getenv()))));
    door.ifPresent(d -> err.println("scripts may come by " + d.file()));
    try {
      if (arguments.script().isPresent() && scripts.isPresent()) {
        return new FileScript(scripts.get(), out, err, stop).run(arguments.script().get(), arguments.limit());
      }
      if (instead.isPresent()) {
        return instead.get().run();
      }
      watch(arguments);
      return loaded.code();
    } finally {
      door.ifPresent(Scripts.Door::close);
    }
  }

  private void sayWhatIsLeftOut(Set<String> shown) {
    List<String> names = host.ruics().stream().map(Ruic::name).toList();
    host.ruics().stream().filter(ruic -> ruic.startsShown() && !shown.contains(ruic.name()))
        .forEach(ruic -> err.println(ruic.name()
            + " is not started, as it starts when it is shown; show it with  --show \"" + ruic.name() + "\""));
    shown.stream().filter(name -> !names.contains(name))
        .forEach(
            name -> err.println("there is no robot UI '" + name + "' to show; there are: " + String.join(", ", names)));
  }

  private void watch(Arguments arguments) throws InterruptedException {
    if (arguments.watch()) {
      try (WatchedFiles files = new WatchedFiles(host, err)) {
        repeat(arguments);
      }
    } else {
      repeat(arguments);
    }
  }

  private Exit load(List<Path> files) {
    Exit result = Exit.FINE;
    for (Path file : files) {
      Exit one = load(file);
      result = one == Exit.FINE ? result : one;
    }
    return result;
  }

  private Exit open(List<Path> files) {
    List<CompletableFuture<FileOutcome>> outcomes =
        files.stream().map(file -> host.files().open(file).toCompletableFuture()).toList();
    Exit result = Exit.FINE;
    for (CompletableFuture<FileOutcome> each : outcomes) {
      Exit one = say(each.join());
      result = result == Exit.FINE ? one : result;
    }
    return result;
  }

  private Exit say(FileOutcome outcome) {
    return switch (outcome) {
      case FileOutcome.Opened opened -> {
        opened.problems().forEach(p -> err.println(CheckPrinter.line(p)));
        yield Exit.FINE;
      }
      case FileOutcome.NotOpened refused -> {
        err.println(refused.reason());
        yield Exit.UNREADABLE;
      }
    };
  }

  private Exit load(Path file) {
    Optional<String> unreadable = Configuration.unreadable(file);
    if (unreadable.isPresent()) {
      err.println(unreadable.get());
      return Exit.UNREADABLE;
    }
    List<Problem> problems = host.load(file);
    problems.forEach(p -> err.println(CheckPrinter.line(p)));
    boolean wrong = problems.stream().anyMatch(p -> p.severity() == Problem.Severity.ERROR);
    return wrong ? Exit.ERRORS : Exit.FINE;
  }

  private void repeat(Arguments arguments) throws InterruptedException {
    Output output = arguments.json() ? new JsonLines(host, out) : TextOutput.create(host, out, new Terminal());
    long end = arguments.limit().map(d -> System.nanoTime() + d.toNanos()).orElse(Long.MAX_VALUE);
    try {
      while (!waitFor(output.periodMillis(), end) && System.nanoTime() < end) {
        output.show();
      }
    } finally {
      output.end();
    }
  }

  private boolean waitFor(long millis, long end) throws InterruptedException {
    long left = end == Long.MAX_VALUE ? millis : TimeUnit.NANOSECONDS.toMillis(end - System.nanoTime());
    return stop.await(Math.clamp(left, 0, millis), TimeUnit.MILLISECONDS);
  }
}
