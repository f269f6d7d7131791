package org.robotui.workbench.internal.rcp;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.DirectoryDialog;
import org.eclipse.swt.widgets.Display;
import org.robotui.api.config.WriteFailure;
import org.robotui.api.host.Ruic;
import org.robotui.api.record.Recorder;
import org.robotui.api.record.RecorderState;
import org.robotui.api.record.RecordingChoice;
import org.robotui.api.record.RecordingOutcome;
import org.robotui.api.record.RecordingPlan;
import org.robotui.ui.control.PopupMenu;
import org.robotui.workbench.internal.WorkbenchSession;

/** What the record button offers. Display thread only; files are written beside it. */
final class RecordMenu {
  private static final String FOLDER = "recordings";
  private static final Duration RECENT = Duration.ofSeconds(30);

  private final WorkbenchSession session;
  private final Recorder recorder;
  private final Optional<Ruic> shown;
  private final Display display = Display.getCurrent();

  RecordMenu(WorkbenchSession session, Recorder recorder, Optional<Ruic> shown) {
    this.session = session;
    this.recorder = recorder;
    this.shown = shown;
  }

  void openBelow(Control control) {
    RecorderState state = recorder.state();
    PopupMenu menu = new PopupMenu(control);
    if (state.recording().isPresent()) {
      menu.push("Stop Recording", () -> tell(recorder::stop));
    } else {
      menu.push("Record All Robots", () -> start(RecordingChoice.ALL));
      shown.map(Ruic::name).ifPresent(
          name -> menu.push("Record " + name, () -> start(new RecordingChoice(List.of(name), List.of()))));
    }
    menu.line();
    boolean kept = state.recent().isPresent();
    String recent = "the Last " + state.recent().map(RecorderState.Recent::limit).orElse(RECENT).toSeconds() + " s";
    menu.check("Keep " + recent, kept, on -> tell(() -> keep(on)));
    menu.push("Save " + recent, kept, () -> tell(() -> inFolder(() -> recorder.saveRecent(folder()))));
    menu.line();
    menu.push("Folder: " + folder() + "...", () -> choose(control));
    menu.openBelow(control);
  }

  private void start(RecordingChoice choice) {
    tell(() -> inFolder(() -> recorder.start(RecordingPlan.of(folder()).choosing(choice))));
  }

  private RecordingOutcome keep(boolean on) {
    if (on) {
      return recorder.keepRecent(RECENT, RecordingChoice.ALL);
    }
    recorder.forgetRecent();
    return new RecordingOutcome.Done(List.of(), "the last seconds are kept no more");
  }

  /** The folder that is there from the start is made when it is first needed; one that a user chose is there. */
  private RecordingOutcome inFolder(Supplier<RecordingOutcome> action) {
    Path folder = folder();
    try {
      if (folder.equals(usual()) && !Files.isDirectory(folder)) {
        Files.createDirectory(folder);
      }
      return action.get();
    } catch (IOException e) {
      return new RecordingOutcome.Refused(folder + " cannot be made: " + WriteFailure.reason(e));
    }
  }

  private Path folder() {
    return session.state().get(FOLDER).map(Path::of).orElseGet(RecordMenu::usual);
  }

  private static Path usual() {
    return Path.of(System.getProperty("user.home"), "robotui-recordings");
  }

  private void choose(Control control) {
    DirectoryDialog dialog = new DirectoryDialog(control.getShell());
    dialog.setText("Folder for Recordings");
    dialog.setFilterPath(folder().toString());
    Optional.ofNullable(dialog.open()).ifPresent(chosen -> session.state().put(FOLDER, chosen));
  }

  private void tell(Supplier<RecordingOutcome> action) {
    session.configurations().background().execute(() -> {
      RecordingOutcome outcome = action.get();
      if (!display.isDisposed()) {
        display.asyncExec(() -> {
          session.alerts().pass(outcome.sentence());
          session.refresh();
        });
      }
    });
  }
}
