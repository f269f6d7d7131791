package org.robotui.uic.console.internal;

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
final class FakeScripts implements Scripts, ScriptSession {
  final List<String> opened = new ArrayList<>();
  final List<ScriptSource> runs = new ArrayList<>();
  final List<CompletableFuture<ScriptOutcome>> outcomes = new ArrayList<>();
  Consumer<String> output = text -> {};
  Completion completion = new Completion(0, List.of());
  boolean stopped;
  boolean closed;

  void end(ScriptOutcome outcome) {
    outcomes.getLast().complete(outcome);
  }

  @Override
  public ScriptSession open(String name, Consumer<String> output) {
    opened.add(name);
    this.output = output;
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
}
