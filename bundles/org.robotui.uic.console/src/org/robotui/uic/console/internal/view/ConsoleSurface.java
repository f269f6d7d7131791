package org.robotui.uic.console.internal.view;

import java.nio.file.Path;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.FileDialog;
import org.robotui.ui.Icon;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewSurface;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.QuietButton;
import org.robotui.ui.control.SaveDialog;
import org.robotui.ui.control.Spoken;
import org.robotui.uic.console.internal.model.InputHistory;
import org.robotui.uic.console.internal.model.Transcript;

/** What is seen of the console while it is shown. Display thread. */
public final class ConsoleSurface implements ViewSurface {
  private static final int MOST_SHOWN = 6;
  private static final String[] SCRIPTS = {"*.js", "*"};

  private final Transcript transcript;
  private final ConsoleHands hands;
  private final UiContext context;
  private final Composite root;
  private final OutputText output;
  private final ScriptField field;
  private final GridData place = Boxes.line(0);
  private final QuietButton stop;

  /** In a part of a window. */
  public ConsoleSurface(Composite parent, UiContext context, Transcript transcript, InputHistory history,
      ConsoleHands hands) {
    this.transcript = transcript;
    this.hands = hands;
    this.context = context;
    Theme theme = context.theme();
    root = Boxes.root(parent, theme, this::focus);
    output = new OutputText(root, theme);
    output.control().setLayoutData(Boxes.fill());
    Spoken.name(output.control(), "What the console says");
    Boxes.rule(root, theme);
    Composite line = Boxes.bar(root, theme, 2);
    line.setBackground(theme.color(Role.GROUND));
    field = new ScriptField(line, theme, history, hands);
    field.control().setLayoutData(place);
    Spoken.name(field.control(), "Script to run");
    stop = new QuietButton(line, theme, hands::stop).text("Stop").icon(Icon.STOP).hint("Stop what runs (Esc)");
    stop.setLayoutData(Boxes.middle());
    Boxes.seen(stop, false);
    field.control().addListener(SWT.Modify, e -> fit());
    fit();
  }

  private boolean focus() {
    return field.control().setFocus();
  }

  @Override
  public Control control() {
    return root;
  }

  /** Shows what is new. */
  public void show(boolean running) {
    if (root.isDisposed()) {
      return;
    }
    output.show(transcript);
    field.running(running);
    context.note(running ? "running" : "");
    if (Boxes.seen(stop, running)) {
      root.layout(true, true);
    }
  }

  /** Asks for a file, and runs it. */
  public void askForScript() {
    FileDialog dialog = new FileDialog(root.getShell(), SWT.OPEN);
    dialog.setText("Run a script");
    dialog.setFilterExtensions(SCRIPTS);
    Optional.ofNullable(dialog.open()).map(Path::of).ifPresent(hands::open);
  }

  /** Asks for a file, and writes to it. */
  public void save() {
    SaveDialog.ask(root, "Save as a script", "console.js", SCRIPTS).ifPresent(hands::save);
  }

  /** As high as what is typed, up to some lines. */
  private void fit() {
    int lines = Math.min(MOST_SHOWN, field.control().getLineCount());
    int height = lines * field.control().getLineHeight() + 2 * Theme.STEP;
    if (place.heightHint != height) {
      place.heightHint = height;
      root.layout(true, true);
    }
  }
}
