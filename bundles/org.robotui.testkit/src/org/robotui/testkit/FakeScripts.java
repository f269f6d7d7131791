package org.robotui.testkit;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.Consumer;
import org.robotui.api.script.ScriptFunction;
import org.robotui.api.script.ScriptOutcome;
import org.robotui.api.script.ScriptSession;
import org.robotui.api.script.ScriptSource;
import org.robotui.api.script.Scripts;

/** Sessions whose scripts end when the test says so. */
public final class FakeScripts implements Scripts, ScriptSession {
  /** Names of the sessions that were opened. */
  public final List<String> opened = new ArrayList<>();
  /** What was run, in all sessions. */
  public final List<ScriptSource> runs = new ArrayList<>();
  /** How they end, once the test says so. */
  public final List<CompletableFuture<ScriptOutcome>> outcomes = new ArrayList<>();
  /** Where the newest session prints. */
  public Consumer<String> output = text -> {};
  /** Where lines of recorded actions go. */
  public Consumer<String> recorded = text -> {};
  /** What every line is completed with. */
  public Completion completion = new Completion(0, List.of());
  /** Whether the newest session was stopped. */
  public boolean stopped;
  /** Whether the newest session was closed. */
  public boolean closed;

  /** Nothing was run yet. */
  public FakeScripts() {}

  /**
   * Ends the newest script.
   *
   * @param outcome how
   */
  public void end(ScriptOutcome outcome) {
    outcomes.getLast().complete(outcome);
  }

  @Override
  public ScriptSession open(String name, Consumer<String> output) {
    opened.add(name);
    this.output = output;
    closed = false;
    return this;
  }

  @Override
  public CompletionStage<ScriptOutcome> run(ScriptSource source) {
    runs.add(source);
    outcomes.add(new CompletableFuture<>());
    return outcomes.getLast();
  }

  @Override
  public void stop(String reason) {
    stopped = true;
  }

  @Override
  public Completion complete(String line) {
    return completion;
  }

  @Override
  public void close() {
    closed = true;
  }

  @Override
  public List<ScriptFunction> functions() {
    return List.of();
  }

  @Override
  public Optional<Door> listen(Path folder) {
    return Optional.empty();
  }

  @Override
  public ActionRecording record(Consumer<String> line) {
    recorded = line;
    return () -> recorded = text -> {};
  }
}
