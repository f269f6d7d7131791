package org.robotui.uic.console.internal.model;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.robotui.api.script.ScriptLine;
import org.robotui.api.script.ScriptOutcome;
import org.robotui.api.script.ScriptSession;
import org.robotui.api.script.ScriptSource;
import org.robotui.api.script.Scripts;
import org.robotui.uic.console.internal.model.ConsoleLine.Kind;

/**
 * Runs what is typed, one after another, in one session: it begins with the first line, so that a console that nobody
 * uses is nobody who could have control. Any thread.
 */
public final class Runs implements AutoCloseable {
  private static final String NAME = "console";

  private final Scripts scripts;
  private final String ruic;
  private final Transcript transcript;
  private final List<String> done = new ArrayList<>();
  private Optional<ScriptSession> session = Optional.empty();
  private Optional<Scripts.ActionRecording> recording = Optional.empty();
  private int running;
  private boolean closed;

  /** In a robot UI of a name. */
  public Runs(Scripts scripts, String ruic, Transcript transcript) {
    this.scripts = scripts;
    this.ruic = ruic;
    this.transcript = transcript;
  }

  /** Runs what was typed. */
  public void type(String text) {
    transcript.add(Kind.INPUT, text);
    run(new ScriptSource(NAME, text), true);
  }

  /** Runs a file. */
  public void file(ScriptSource source) {
    transcript.add(Kind.NOTE, "running " + source.name());
    run(source, false);
  }

  private synchronized void run(ScriptSource source, boolean typed) {
    session().ifPresent(open -> {
      running++;
      open.run(source).thenAccept(outcome -> ended(source, typed, outcome));
    });
  }

  private synchronized void ended(ScriptSource source, boolean typed, ScriptOutcome outcome) {
    running--;
    switch (outcome) {
      case ScriptOutcome.Done ok -> {
        if (!ok.text().isEmpty()) {
          transcript.add(Kind.VALUE, ok.text());
        }
        if (typed) {
          done.add(source.text());
        }
      }
      case ScriptOutcome.Exited exited -> transcript.add(Kind.NOTE,
          "the script ended with " + exited.code() + "; a console goes on: close the view to end it");
      case ScriptOutcome.Failed failed -> transcript.add(Kind.ERROR, failed.toString());
      case ScriptOutcome.Stopped stopped -> transcript.add(Kind.ERROR, stopped.toString());
    }
  }

  private Optional<ScriptSession> session() {
    if (session.isEmpty() && !closed) {
      ScriptSession made = scripts.open("the console of " + ruic, text -> transcript.add(Kind.OUTPUT, text));
      session = Optional.of(made);
      made.run(new ScriptSource(NAME, ScriptLine.call("use", ruic))).thenAccept(outcome -> {
        if (outcome instanceof ScriptOutcome.Failed failed) {
          transcript.add(Kind.ERROR, failed.toString());
        }
      });
    }
    return session;
  }

  /** What could stand at the end of a line. */
  public synchronized ScriptSession.Completion complete(String line) {
    return session().map(open -> open.complete(line))
        .orElseGet(() -> new ScriptSession.Completion(line.length(), List.of()));
  }

  /** Begins to write down what the user does, or ends it. May wait for a moment. */
  public void record() {
    Optional<Scripts.ActionRecording> ended = takeRecording();
    if (ended.isPresent()) {
      ended.get().close();
      transcript.add(Kind.NOTE, "recorded; Save writes it, with what was typed");
    } else {
      begin();
    }
  }

  private synchronized Optional<Scripts.ActionRecording> takeRecording() {
    Optional<Scripts.ActionRecording> taken = recording;
    recording = Optional.empty();
    return taken;
  }

  private synchronized void begin() {
    if (!closed && recording.isEmpty()) {
      transcript.add(Kind.NOTE, "what you do is written down: views, perspectives, control, stops, the timeline");
      recording = Optional.of(scripts.record(this::recorded));
    }
  }

  private synchronized void recorded(String line) {
    transcript.add(Kind.RECORDED, line);
    done.add(line);
  }

  /** Whether what the user does is written down. */
  public synchronized boolean isRecording() {
    return recording.isPresent();
  }

  /** Stops what runs. */
  public synchronized void stop() {
    session.ifPresent(open -> open.stop("stopped in the console"));
  }

  /** Whether something runs or waits. */
  public synchronized boolean isRunning() {
    return running > 0;
  }

  /** What was typed and came to its end, and what the user was seen to do, as a script; empty where nothing was. */
  public synchronized String script() {
    return done.stream().map(text -> text + "\n").collect(Collectors.joining());
  }

  @Override
  public void close() {
    takeRecording().ifPresent(Scripts.ActionRecording::close);
    end();
  }

  private synchronized void end() {
    closed = true;
    session.ifPresent(ScriptSession::close);
    session = Optional.empty();
  }
}
