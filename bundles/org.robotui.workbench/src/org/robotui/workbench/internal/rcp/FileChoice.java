package org.robotui.workbench.internal.rcp;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.eclipse.swt.SWT;
import org.eclipse.swt.dnd.DND;
import org.eclipse.swt.dnd.DropTarget;
import org.eclipse.swt.dnd.DropTargetAdapter;
import org.eclipse.swt.dnd.DropTargetEvent;
import org.eclipse.swt.dnd.FileTransfer;
import org.eclipse.swt.dnd.Transfer;
import org.eclipse.swt.widgets.FileDialog;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.ui.IWorkbenchWindow;
import org.robotui.api.FileKind;
import org.robotui.api.host.FileOutcome;
import org.robotui.workbench.internal.WorkbenchSession;
import org.robotui.workbench.internal.model.WindowModel;

/** Recordings and configurations that a user chooses, or drops on a window. Display thread only. */
final class FileChoice {
  private static final String FOLDER = "recordings";

  private final WorkbenchSession session;
  private final IWorkbenchWindow window;

  FileChoice(WorkbenchSession session, IWorkbenchWindow window) {
    this.session = session;
    this.window = window;
  }

  /** Lets the user choose recordings, and opens them. */
  void choose() {
    FileDialog dialog = new FileDialog(window.getShell(), SWT.OPEN | SWT.MULTI);
    dialog.setText("Open recording");
    List<FileKind> kinds = session.host().files().kinds();
    dialog.setFilterExtensions(
        Stream.concat(kinds.stream().map(FileChoice::pattern), Stream.of("*")).toArray(String[]::new));
    dialog.setFilterNames(Stream.concat(kinds.stream().map(kind -> kind.label() + " (" + words(kind) + ")"),
        Stream.of("All files")).toArray(String[]::new));
    session.state().get(FOLDER).ifPresent(dialog::setFilterPath);
    if (dialog.open() != null) {
      session.state().put(FOLDER, dialog.getFilterPath());
      Stream.of(dialog.getFileNames()).map(name -> Path.of(dialog.getFilterPath(), name)).forEach(this::open);
    }
  }

  /** The dialog of the desktop tells capital letters apart. */
  private static String pattern(FileKind kind) {
    return Stream.concat(kind.extensions().stream().flatMap(e -> Stream.of(e, e.toUpperCase(Locale.ROOT)))
        .map(e -> "*." + e), names(kind)).collect(Collectors.joining(";"));
  }

  private static String words(FileKind kind) {
    return Stream.concat(kind.extensions().stream().map(e -> "*." + e), names(kind)).collect(Collectors.joining(", "));
  }

  /** The dialog has no folders; a file in one stands for it. */
  private static Stream<String> names(FileKind kind) {
    return kind.folders().stream().filter(name -> !name.contains("*"));
  }

  /** Files may be dropped anywhere on the window. */
  void takeDrops() {
    Shell shell = window.getShell();
    DropTarget target = new DropTarget(shell, DND.DROP_COPY | DND.DROP_MOVE | DND.DROP_LINK | DND.DROP_DEFAULT);
    target.setTransfer(new Transfer[]{FileTransfer.getInstance()});
    target.addDropListener(new DropTargetAdapter() {
      @Override
      public void dragEnter(DropTargetEvent event) {
        event.detail = DND.DROP_COPY; // the file stays where it is
      }

      @Override
      public void dragOperationChanged(DropTargetEvent event) {
        event.detail = DND.DROP_COPY;
      }

      @Override
      public void drop(DropTargetEvent event) {
        if (event.data instanceof String[] names) {
          Stream.of(names).map(Path::of).forEach(FileChoice.this::open);
        }
      }
    });
  }

  /** Opens a configuration, or a file as a robot. */
  void open(Path file) {
    String name = file.getFileName().toString().toLowerCase(Locale.ROOT);
    boolean configuration = (name.endsWith(".yaml") || name.endsWith(".yml"))
        && session.host().files().kinds().stream().noneMatch(kind -> kind.place(file).isPresent());
    if (configuration) {
      session.configurations().load(file);
    } else {
      WindowModel shown = session.model(window);
      session.configurations().open(file, outcome -> show(shown, outcome));
    }
  }

  private void show(WindowModel shown, FileOutcome outcome) {
    if (outcome instanceof FileOutcome.Opened opened) {
      opened.ruics().stream().findFirst().ifPresent(name -> session.showWhenThere(shown, name));
    }
  }

  /** What the selected robot was opened from, to be closed. */
  static Optional<String> closing(WorkbenchSession session, String ruic) {
    return session.configurations().openedAs(ruic).map(file -> "Close " + file.getFileName());
  }
}
