package org.robotui.script.internal.engine;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.robotui.api.command.Principal;
import org.robotui.api.script.ScriptFunction;
import org.robotui.api.script.ScriptOutcome;
import org.robotui.api.script.ScriptSource;
import org.robotui.script.internal.function.StandardFunctions;
import org.robotui.testkit.host.FakeHost;

/** A session with a host that a test fills. */
public final class Console implements AutoCloseable {
  public final FakeHost host = new FakeHost();
  public final List<String> printed = new CopyOnWriteArrayList<>();
  public final Session session;

  /** A console that stops what computes for two seconds. */
  public Console(ScriptFunction... more) {
    this(Duration.ofSeconds(2), new HeapLook(), more);
  }

  Console(Duration computing, HeapLook heap, ScriptFunction... more) {
    List<ScriptFunction> all = new ArrayList<>(List.of(more));
    all.addAll(StandardFunctions.all(() -> List.copyOf(all)));
    session = new Session(host, new Principal("script-1", "the script", Principal.Kind.SCRIPT), printed::add,
        () -> List.copyOf(all), () -> {}, new ScriptLimits(computing, heap));
  }

  /** Runs a script to its end. */
  public ScriptOutcome run(String... lines) {
    try {
      return session.run(new ScriptSource("test.js", String.join("\n", lines))).toCompletableFuture().get(120,
          TimeUnit.SECONDS);
    } catch (InterruptedException | ExecutionException | TimeoutException e) {
      throw new AssertionError(e);
    }
  }

  /** The value of a script that must come to its end. */
  public Object value(String... lines) {
    ScriptOutcome outcome = run(lines);
    if (outcome instanceof ScriptOutcome.Done done) {
      return done.value().orElse(null);
    }
    throw new AssertionError(outcome.toString());
  }

  /** Why a script fails. */
  public String failure(String... lines) {
    ScriptOutcome outcome = run(lines);
    if (outcome instanceof ScriptOutcome.Failed failed) {
      return failed.toString();
    }
    throw new AssertionError(outcome.toString());
  }

  @Override
  public void close() {
    session.close();
  }
}
