package org.robotui.uic.console.internal;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.eclipse.swt.widgets.Composite;
import org.robotui.api.UicContext;
import org.robotui.api.config.AtomicFile;
import org.robotui.api.config.WriteFailure;
import org.robotui.api.script.ScriptSession.Completion;
import org.robotui.api.script.ScriptSource;
import org.robotui.api.script.Scripts;
import org.robotui.ui.Icon;
import org.robotui.ui.SurfaceUic;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewKey;
import org.robotui.uic.console.internal.model.ConsoleLine.Kind;
import org.robotui.uic.console.internal.model.InputHistory;
import org.robotui.uic.console.internal.model.Runs;
import org.robotui.uic.console.internal.model.Transcript;
import org.robotui.uic.console.internal.view.ConsoleHands;
import org.robotui.uic.console.internal.view.ConsoleSurface;

/** The view: what is typed runs in a session that ends with it. */
final class ConsoleUic extends SurfaceUic<ConsoleSurface> {
  private final UicContext context;
  private final Transcript transcript = new Transcript();
  private final Runs runs;
  private final InputHistory history;
  private long told;
  private boolean toldRunning;

  ConsoleUic(UicContext context, Scripts scripts) {
    this.context = context;
    this.runs = new Runs(scripts, context.ruic().name(), transcript);
    this.history = new InputHistory(
        context.settings().current().list(ConsoleType.HISTORY).stream().map(Object::toString).toList());
    transcript.add(Kind.NOTE, "Type JavaScript, such as ports() or value(\"base.odom\"); help() lists all functions.");
    offers().action("run_file", "Run a script file\u2026", Icon.PLAY, ConsoleSurface::askForScript)
        .action("save", "Save what was typed and recorded as a script\u2026", Icon.SAVE, ConsoleSurface::save)
        .add("record", "Write down what I do as a script", Icon.TEXT, runs::isRecording,
            () -> context.background().execute(runs::record))
        .add("stop", "Stop what runs", Icon.STOP, runs::stop)
        .add("clear", "Clear", Icon.RESTART, transcript::clear);
  }

  @Override
  public boolean tick(long now) {
    boolean running = runs.isRunning();
    long end = transcript.end();
    boolean changed = running != toldRunning || end != told;
    toldRunning = running;
    told = end;
    return changed;
  }

  @Override
  protected ConsoleSurface open(Composite parent, UiContext ui) {
    return new ConsoleSurface(parent, ui, transcript, history, hands());
  }

  ConsoleHands hands() {
    return new Hands();
  }

  @Override
  protected void refresh(ConsoleSurface shown) {
    shown.show(runs.isRunning());
  }

  @Override
  public List<ViewKey> keys() {
    return List.of(
        new ViewKey("Enter", "Run what is typed"),
        new ViewKey("Shift+Enter", "Begin a new line"),
        new ViewKey("Tab", "Complete"),
        new ViewKey("Up, Down", "Bring back what was typed before"),
        new ViewKey("Esc", "Stop what runs, or clear what is typed"));
  }

  @Override
  public void close() {
    runs.close();
  }

  /** What the user can do. Display thread. */
  private final class Hands implements ConsoleHands {
    @Override
    public void run(String text, List<String> all) {
      runs.type(text);
      context.settings().set(ConsoleType.HISTORY, all);
      refresh();
    }

    @Override
    public void stop() {
      runs.stop();
    }

    @Override
    public Completion complete(String line) {
      return runs.complete(line);
    }

    @Override
    public void open(Path file) {
      context.background().execute(() -> {
        try {
          runs.file(ScriptSource.read(file));
        } catch (IOException e) {
          transcript.add(Kind.ERROR, e.getMessage());
        }
      });
    }

    @Override
    public void save(Path file) {
      String script = runs.script();
      if (script.isEmpty()) {
        transcript.add(Kind.NOTE,
            "nothing was typed that has come to its end, and nothing was recorded: there is nothing to save");
        return;
      }
      context.background().execute(() -> {
        try {
          AtomicFile.write(file, script);
          transcript.add(Kind.NOTE, "saved to " + file + "; ./robotui run CONFIG --script FILE runs it");
        } catch (IOException e) {
          transcript.add(Kind.ERROR, "cannot write " + file + ": " + WriteFailure.reason(e));
        }
      });
    }
  }
}
