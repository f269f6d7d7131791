package org.robotui.ui.control;

import java.util.Optional;
import java.util.function.Predicate;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Button;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Label;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.swt.widgets.Text;

/** Asks for one line. Display thread; returns when it is closed. */
public final class NameDialog {
  private static final int WIDTH = 260;
  private static final int WIDEST = 460;
  private static final int MARGIN = 12;

  private final Shell shell;
  private Optional<String> answer = Optional.empty();

  private NameDialog(Control over, String title, String question, String before, Predicate<String> fits) {
    shell = new Shell(over.getShell(), SWT.DIALOG_TRIM | SWT.APPLICATION_MODAL);
    shell.setText(title);
    GridLayout layout = new GridLayout(1, false);
    layout.marginWidth = MARGIN;
    layout.marginHeight = MARGIN;
    shell.setLayout(layout);
    Label asked = new Label(shell, SWT.WRAP);
    asked.setText((question + ":").replace("&", "&&"));
    GridData lines = new GridData(SWT.FILL, SWT.CENTER, true, false);
    lines.widthHint = Math.clamp(asked.computeSize(SWT.DEFAULT, SWT.DEFAULT).x, WIDTH, WIDEST);
    asked.setLayoutData(lines);
    Text text = new Text(shell, SWT.SINGLE | SWT.BORDER);
    GridData wide = new GridData(SWT.FILL, SWT.CENTER, true, false);
    wide.widthHint = WIDTH;
    text.setLayoutData(wide);
    text.setText(before);
    text.selectAll();
    buttons(text, fits);
    shell.pack();
    shell.setLocation(middle(over));
  }

  /** Over the middle of what it asks for: where window managers put it otherwise, nobody looks. */
  private Point middle(Control over) {
    Point size = over.getSize();
    Point own = shell.getSize();
    return over.toDisplay((size.x - own.x) / 2, (size.y - own.y) / 2);
  }

  /**
   * Asks for a name, and waits.
   *
   * @param over above which it opens
   * @param title what is asked for
   * @param before what is written there at the beginning
   * @return the name without blanks around it; none where nothing was written or it was cancelled
   */
  public static Optional<String> ask(Control over, String title, String before) {
    return ask(over, title, before, words -> !words.isBlank());
  }

  /**
   * Asks for what fits, else there is no OK, and waits.
   *
   * @param over above which it opens
   * @param title what is asked for
   * @param before what is written there at the beginning
   * @param fits whether what is written is an answer
   * @return the answer without blanks around it; none where it was cancelled
   */
  public static Optional<String> ask(Control over, String title, String before, Predicate<String> fits) {
    return ask(over, title, title, before, fits);
  }

  /**
   * Asks for what fits, with more words than a title has room for, and waits.
   *
   * @param over above which it opens
   * @param title of the window
   * @param question what is asked for, in any number of lines
   * @param before what is written there at the beginning
   * @param fits whether what is written is an answer
   * @return the answer without blanks around it; none where it was cancelled
   */
  public static Optional<String> ask(Control over, String title, String question, String before,
      Predicate<String> fits) {
    NameDialog dialog = new NameDialog(over, title, question, before, fits);
    dialog.shell.open();
    while (!dialog.shell.isDisposed()) {
      if (!dialog.shell.getDisplay().readAndDispatch()) {
        dialog.shell.getDisplay().sleep();
      }
    }
    return dialog.answer.map(String::strip).filter(a -> !a.isEmpty());
  }

  private void buttons(Text text, Predicate<String> fits) {
    Composite bar = new Composite(shell, SWT.NONE);
    bar.setLayoutData(new GridData(SWT.END, SWT.CENTER, true, false));
    bar.setLayout(new GridLayout(2, true));
    Button cancel = button(bar, "Cancel");
    cancel.addListener(SWT.Selection, e -> shell.close());
    Button ok = button(bar, "OK");
    ok.addListener(SWT.Selection, e -> {
      answer = Optional.of(text.getText());
      shell.close();
    });
    ok.setEnabled(fits.test(text.getText()));
    text.addListener(SWT.Modify, e -> ok.setEnabled(fits.test(text.getText())));
    shell.setDefaultButton(ok);
  }

  private static Button button(Composite bar, String words) {
    Button button = new Button(bar, SWT.PUSH);
    button.setText(words);
    button.setLayoutData(new GridData(SWT.FILL, SWT.CENTER, true, false));
    return button;
  }
}
