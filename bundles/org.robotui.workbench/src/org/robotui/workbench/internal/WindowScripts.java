package org.robotui.workbench.internal;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import java.util.function.IntConsumer;
import org.robotui.api.config.Printable;
import org.robotui.api.config.UserFolder;
import org.robotui.api.script.ScriptOutcome;
import org.robotui.api.script.ScriptSession;
import org.robotui.api.script.ScriptSource;
import org.robotui.api.script.Scripts;

/**
 * The script and the socket for scripts that the command line asks for. What the script prints goes where the workbench
 * was started from; where it fails, the window says so, too.
 */
final class WindowScripts implements AutoCloseable {
  private final Arguments arguments;
  private final PrintStream out;
  private final PrintStream err;
  private final Consumer<String> alert;
  private final IntConsumer exit;
  private final AtomicBoolean begun = new AtomicBoolean();
  private volatile Optional<ScriptSession> session = Optional.empty();
  private volatile Optional<Scripts.Door> door = Optional.empty();

  /** Where the command line asks for them; they begin once the configurations are read. */
  static Optional<WindowScripts> of(WorkbenchSession session, PrintStream out, PrintStream err, IntConsumer exit) {
    Arguments arguments = session.arguments();
    if (arguments.script().isEmpty() && !arguments.scriptSocket()) {
      return Optional.empty();
    }
    WindowScripts scripts = new WindowScripts(arguments, out, err,
        sentence -> session.later(() -> session.alerts().tell("", sentence)), exit);
    Runnable begin = () -> session.configurations().background().execute(scripts::begin);
    session.onLoaded(() -> {
      if (session.configurations().areRead()) {
        begin.run();
      }
    });
    if (arguments.configurations().isEmpty()) {
      begin.run();
    }
    return Optional.of(scripts);
  }

  /**
   * Told of failures with {@code alert}, and that the script wants the workbench to end with {@code exit}: any thread.
   */
  WindowScripts(Arguments arguments, PrintStream out, PrintStream err, Consumer<String> alert, IntConsumer exit) {
    this.arguments = arguments;
    this.out = out;
    this.err = err;
    this.alert = alert;
    this.exit = exit;
  }

  /** Once the configurations are read; does nothing later. */
  void begin() {
    if (begun.compareAndSet(false, true)) {
      WorkbenchServices.scripts().ifPresentOrElse(this::begin, () -> failed("what runs scripts is not installed"));
    }
  }

  private void begin(Scripts scripts) {
    if (arguments.scriptSocket()) {
      door = scripts.listen(UserFolder.sockets(UserFolder.state(System.getProperties(), System.getenv())));
      door.ifPresent(d -> err.println("scripts may come by " + d.file()));
    }
    arguments.script().ifPresent(file -> run(scripts, file));
  }

  private void run(Scripts scripts, Path file) {
    try {
      ScriptSource source = ScriptSource.read(file);
      ScriptSession opened =
          scripts.open("the script " + source.name(), this::say);
      session = Optional.of(opened);
      opened.run(source).thenAccept(outcome -> ended(opened, outcome));
    } catch (IOException e) {
      failed(e.getMessage());
    }
  }

  private void say(String text) {
    text.lines().map(Printable::of).forEach(out::println);
  }

  private void ended(ScriptSession of, ScriptOutcome outcome) {
    of.close();
    switch (outcome) {
      case ScriptOutcome.Done done -> {}
      case ScriptOutcome.Exited exited -> exit.accept(exited.code());
      case ScriptOutcome.Failed wrong -> failed(wrong.toString());
      case ScriptOutcome.Stopped stopped -> failed(stopped.toString());
    }
  }

  private void failed(String sentence) {
    err.println(Printable.of(sentence));
    alert.accept(sentence);
  }

  @Override
  public void close() {
    session.ifPresent(ScriptSession::close);
    door.ifPresent(Scripts.Door::close);
  }
}
