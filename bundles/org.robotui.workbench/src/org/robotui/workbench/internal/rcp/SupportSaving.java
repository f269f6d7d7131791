package org.robotui.workbench.internal.rcp;

import java.io.IOException;
import java.nio.file.Path;
import java.time.LocalDateTime;
import java.time.format.DateTimeFormatter;
import java.util.List;
import java.util.Locale;
import org.eclipse.jface.dialogs.MessageDialog;
import org.eclipse.swt.widgets.Shell;
import org.robotui.api.config.WriteFailure;
import org.robotui.ui.control.SaveDialog;
import org.robotui.workbench.internal.WorkbenchSession;

/** Saves what somebody needs to know who helps. Display thread only; the writing is done beside it. */
final class SupportSaving {
  private static final String TITLE = "Support Bundle";
  private static final DateTimeFormatter NAME =
      DateTimeFormatter.ofPattern("'robotui-support-'yyyyMMdd-HHmmss'.zip'", Locale.ROOT);

  private final WorkbenchSession session;
  private final Shell shell;

  SupportSaving(WorkbenchSession session, Shell shell) {
    this.session = session;
    this.shell = shell;
  }

  /** Asks where, and begins. */
  void choose() {
    SaveDialog.ask(shell, "Save Support Bundle", NAME.format(LocalDateTime.now()), "*.zip").ifPresent(this::save);
  }

  private void save(Path file) {
    session.alerts().pass("Gathering what is known of this RobotUI...");
    session.configurations().background().execute(() -> {
      String said = write(file);
      shell.getDisplay().asyncExec(() -> tell(said));
    });
  }

  private String write(Path file) {
    try {
      return words(file, session.host().support(file));
    } catch (IOException e) {
      return file + " cannot be written: " + WriteFailure.reason(e);
    }
  }

  static String words(Path file, List<String> contents) {
    return "Saved as " + file + ", which only you can read.\n\nIt has " + contents.size() + " texts: "
        + count(contents, "state/")
        + " logs and other kept files, " + count(contents, "configurations/")
        + " configurations, versions, and the memory, bundles and threads of what runs. CONTENTS.txt in it names all of them."
        + "\n\nWhat is secret by its name (passwords, tokens, keys) is masked. Read it before you give it away: names and "
        + "addresses of robots are in it.";
  }

  private static long count(List<String> contents, String begin) {
    return contents.stream().filter(line -> line.startsWith(begin)).count();
  }

  private void tell(String said) {
    if (!shell.isDisposed()) {
      MessageDialog.openInformation(shell, TITLE, said);
    }
  }
}
