package org.robotui.headless.internal;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.robotui.api.script.ScriptOutcome;
import org.robotui.api.script.ScriptSession;
import org.robotui.api.script.ScriptSource;
import org.robotui.api.script.Scripts;

/** Runs a script to its end; what it prints is all that is seen. */
final class FileScript {
  private static final long LOOK_MILLIS = 20;
  private static final long GRACE_MILLIS = 1000;

  private final Scripts scripts;
  private final PrintStream out;
  private final PrintStream err;
  private final CountDownLatch stop;

  FileScript(Scripts scripts, PrintStream out, PrintStream err, CountDownLatch stop) {
    this.scripts = scripts;
    this.out = out;
    this.err = err;
    this.stop = stop;
  }

  /** Answers the exit code. */
  int run(Path file, Optional<Duration> limit) throws InterruptedException {
    try {
      ScriptSource source = ScriptSource.read(file);
      try (ScriptSession session = scripts.open("the script " + source.name(), out::println)) {
        return code(await(session, session.run(source).toCompletableFuture(), limit));
      }
    } catch (IOException e) {
      err.println(e.getMessage());
      return Exit.UNREADABLE.code();
    }
  }

  private ScriptOutcome await(ScriptSession session, CompletableFuture<ScriptOutcome> end, Optional<Duration> limit)
      throws InterruptedException {
    long last = limit.map(d -> System.nanoTime() + d.toNanos()).orElse(Long.MAX_VALUE);
    while (!end.isDone() && stop.getCount() > 0 && System.nanoTime() < last) {
      stop.await(LOOK_MILLIS, TimeUnit.MILLISECONDS);
    }
    if (!end.isDone()) {
      session.stop(stop.getCount() > 0 ? "the time of -for is over" : "RobotUI ends");
    }
    try {
      return end.get(GRACE_MILLIS, TimeUnit.MILLISECONDS);
    } catch (ExecutionException | TimeoutException e) {
      return new ScriptOutcome.Failed("the script did not end when it was stopped", "", 0);
    }
  }

  private int code(ScriptOutcome outcome) {
    out.flush();
    switch (outcome) {
      case ScriptOutcome.Done done -> {
        return Exit.FINE.code();
      }
      case ScriptOutcome.Exited exited -> {
        return exited.code();
      }
      case ScriptOutcome.Failed failed -> err.println(failed);
      case ScriptOutcome.Stopped stopped -> err.println(stopped);
    }
    return Exit.SCRIPT.code();
  }
}
