package org.robotui.ui.control;

import java.nio.file.Path;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.FileDialog;

/** Asks where to save something; a file that is there is not written over without asking. Display thread. */
public final class SaveDialog {
  private SaveDialog() {}

  /**
   * Asks, and waits for the answer.
   *
   * @param control whose window it stands before
   * @param title of the dialog
   * @param name that the file would have
   * @param patterns of the files that are listed, for example {@code *.png}; none for all
   * @return the file, or empty where the user gave up
   */
  public static Optional<Path> ask(Control control, String title, String name, String... patterns) {
    FileDialog dialog = new FileDialog(control.getShell(), SWT.SAVE);
    dialog.setText(title);
    dialog.setFileName(name);
    dialog.setFilterExtensions(patterns);
    dialog.setOverwrite(true);
    return Optional.ofNullable(dialog.open()).map(Path::of);
  }
}
