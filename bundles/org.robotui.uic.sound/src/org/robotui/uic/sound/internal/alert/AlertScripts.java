package org.robotui.uic.sound.internal.alert;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.robotui.api.script.ScriptLine;
import org.robotui.api.script.ScriptOutcome;
import org.robotui.api.script.ScriptSession;
import org.robotui.api.script.ScriptSource;
import org.robotui.api.script.Scripts;
import org.robotui.condition.Verdict;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Runs the scripts of alerts when they begin, of each alert one at a time: while it runs, the alert may end and begin
 * again without another one. What scripts print is logged. Safe for all threads; never blocks.
 */
public final class AlertScripts implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(AlertScripts.class);

  private final String ui;
  private final Supplier<Optional<Scripts>> engine;
  private final Executor background;
  private final Consumer<String> tell;
  private final Map<String, ScriptSession> running = new ConcurrentHashMap<>();
  private volatile boolean closed;

  /**
   * For the alerts of one robot UI.
   *
   * @param ui its name
   * @param engine what runs scripts, as long as it is there
   * @param background runs what may block
   * @param tell is told a sentence for users where a script cannot do its work
   */
  public AlertScripts(String ui, Supplier<Optional<Scripts>> engine, Executor background, Consumer<String> tell) {
    this.ui = ui;
    this.engine = engine;
    this.background = background;
    this.tell = tell;
  }

  /** An alert began: runs its script, where it has one. */
  public void begin(AlertConfig alert, Optional<Verdict.Holds> seen) {
    alert.script().ifPresent(file -> background.execute(() -> run(alert, file, seen)));
  }

  private void run(AlertConfig alert, Path file, Optional<Verdict.Holds> seen) {
    String name = String.valueOf(file.getFileName());
    Optional<Scripts> scripts = engine.get();
    if (closed || running.containsKey(alert.name())) {
      LOG.info("{}: {} is not run for '{}', as it runs still", ui, name, alert.name());
      return;
    }
    if (scripts.isEmpty()) {
      tell.accept("the alert '" + alert.name() + "' cannot run " + name
          + ": no bundle that runs scripts is installed (org.robotui.script)");
      return;
    }
    try {
      ScriptSource source = ScriptSource.read(file);
      start(scripts.get(), alert, source, new ScriptSource("alert", head(alert, seen)));
    } catch (IOException e) {
      tell.accept("the alert '" + alert.name() + "' cannot run its script: " + e.getMessage());
    }
  }

  private void start(Scripts scripts, AlertConfig alert, ScriptSource source, ScriptSource head) {
    ScriptSession session = scripts.open("the script " + source.name() + " of the alert '" + alert.name() + "'",
        line -> LOG.info("{}: {}: {}", ui, source.name(), line));
    running.put(alert.name(), session);
    session.run(head);
    session.run(source).thenAccept(outcome -> ended(alert, source.name(), outcome));
    if (closed) {
      end(alert.name());
    }
  }

  /** What a script knows of the alert that runs it. */
  private String head(AlertConfig alert, Optional<Verdict.Holds> seen) {
    return "var alert = {name: " + ScriptLine.literal(alert.name()) + ", when: " + ScriptLine.literal(alert.when())
        + ", source: " + ScriptLine.literal(seen.map(Verdict.Holds::source).orElse("")) + ", value: "
        + ScriptLine.literal(seen.map(Verdict.Holds::value).orElse("")) + ", ui: " + ScriptLine.literal(ui) + "}; "
        + ScriptLine.call("use", ui);
  }

  private void ended(AlertConfig alert, String script, ScriptOutcome outcome) {
    end(alert.name());
    switch (outcome) {
      case ScriptOutcome.Done done -> LOG.info("{}: {} of '{}' is done", ui, script, alert.name());
      case ScriptOutcome.Exited exited -> LOG.info("{}: {} of '{}' is done", ui, script, alert.name());
      case ScriptOutcome.Failed failed -> tell.accept("the script of the alert '" + alert.name() + "' failed: "
          + failed);
      case ScriptOutcome.Stopped stopped -> LOG.warn("{}: the script of '{}' was stopped: {}", ui, alert.name(),
          stopped);
    }
  }

  private void end(String alert) {
    Optional.ofNullable(running.remove(alert)).ifPresent(ScriptSession::close);
  }

  /** Stops those that run: what they move stops, and they give back control. */
  @Override
  public void close() {
    closed = true;
    running.keySet().forEach(this::end);
  }
}
