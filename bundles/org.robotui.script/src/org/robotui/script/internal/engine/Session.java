package org.robotui.script.internal.engine;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.mozilla.javascript.Context;
import org.robotui.api.command.Principal;
import org.robotui.api.host.Host;
import org.robotui.api.script.ScriptFunction;
import org.robotui.api.script.ScriptOutcome;
import org.robotui.api.script.ScriptSession;
import org.robotui.api.script.ScriptSource;

/** Scripts one after another on one thread, with one set of variables. */
public final class Session implements ScriptSession {
  private static final Duration GRACE = Duration.ofSeconds(3);

  private final Supplier<List<ScriptFunction>> functions;
  private final ScriptLimits limits;
  private final Surroundings surroundings;
  private final ExecutorService worker;
  private final List<ScriptRun> runs = new CopyOnWriteArrayList<>();
  private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();
  private final Runnable ended;
  private final Interpreter interpreter;
  private volatile Set<String> variables = Set.of();
  private volatile boolean closed;

  /** A session with the limits that usually hold. */
  public Session(Host host, Principal principal, Consumer<String> output, Supplier<List<ScriptFunction>> functions,
      Runnable ended) {
    this(host, principal, output, functions, ended, ScriptLimits.USUAL);
  }

  Session(Host host, Principal principal, Consumer<String> output, Supplier<List<ScriptFunction>> functions,
      Runnable ended, ScriptLimits limits) {
    this.functions = functions;
    this.limits = limits;
    this.ended = ended;
    this.surroundings = new Surroundings(host, principal, output);
    this.interpreter = new Interpreter(surroundings);
    this.worker = Executors.newSingleThreadExecutor(task -> {
      Thread thread = Thread.ofPlatform().daemon().name("robotui-" + principal.id()).unstarted(task);
      thread.setContextClassLoader(Context.class.getClassLoader()); // where the engine finds its own parts
      return thread;
    });
  }

  @Override
  public synchronized CompletionStage<ScriptOutcome> run(ScriptSource source) {
    ScriptRun run = new ScriptRun(source, limits, threads::getCurrentThreadCpuTime);
    if (closed || runs.stream().anyMatch(r -> r.outcome().isDone())) {
      return CompletableFuture.completedStage(new ScriptOutcome.Stopped(
          closed ? "the session has ended" : "a script before it was given up and still computes; begin a new session",
          source.name(), 0));
    }
    runs.add(run);
    worker.execute(() -> perform(run));
    return run.outcome().minimalCompletionStage();
  }

  private void perform(ScriptRun run) {
    ScriptOutcome outcome = run.begin() ? interpreter.run(run, functions.get())
        : new ScriptOutcome.Stopped(run.stopped().orElse(""), run.source().name(), 0);
    run.end();
    variables = interpreter.variables();
    runs.remove(run);
    run.outcome().complete(outcome);
  }

  @Override
  public void stop(String reason) {
    runs.forEach(run -> stop(run, reason));
    surroundings.release();
  }

  /** The engine does not ask within a function of its own, such as a search in an array of billions. */
  private static void stop(ScriptRun run, String reason) {
    run.stop(reason);
    run.outcome().completeOnTimeout(
        new ScriptOutcome.Stopped(reason + "; it does not answer and was given up", run.source().name(), 0),
        GRACE.toMillis(), TimeUnit.MILLISECONDS);
  }

  @Override
  public Completion complete(String line) {
    return new Completer(surroundings.host(), words()).complete(line);
  }

  private Set<String> words() {
    return Stream.concat(Stream.concat(functions.get().stream().map(ScriptFunction::name), variables.stream()),
        Arrays.stream(Completer.LANGUAGE)).collect(Collectors.toSet());
  }

  @Override
  public void close() {
    synchronized (this) {
      if (closed) {
        return;
      }
      closed = true;
    }
    runs.forEach(run -> stop(run, "the session has ended"));
    surroundings.close();
    worker.shutdown();
    ended.run();
  }
}
