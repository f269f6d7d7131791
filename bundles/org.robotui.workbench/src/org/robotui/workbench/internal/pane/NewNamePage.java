package org.robotui.workbench.internal.pane;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.custom.StyleRange;
import org.eclipse.swt.custom.StyledText;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.FileDialog;
import org.eclipse.swt.widgets.Text;
import org.robotui.api.host.CompositionText;
import org.robotui.ui.Face;
import org.robotui.ui.Icon;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.PopupMenu;
import org.robotui.ui.control.QuietButton;
import org.robotui.workbench.internal.model.NewRobotModel;

/** The third step: the name, the file, and what will stand in it. Display thread only. */
final class NewNamePage extends Composite {
  private static final int INSET = 6;

  private final Theme theme;
  private final NewRobotModel model;
  private final List<Path> open;
  private final Runnable changed;
  private final Text name;
  private final Text file;
  private final StyledText preview;
  private boolean fileTyped;
  private boolean proposing;

  NewNamePage(Composite parent, Theme theme, NewRobotModel model, List<Path> open, Runnable changed) {
    super(parent, SWT.NONE);
    this.theme = theme;
    this.model = model;
    this.open = open;
    this.changed = changed;
    setBackground(theme.color(Role.PANEL));
    GridLayout layout = new GridLayout(4, false);
    layout.marginWidth = Theme.EDGE;
    layout.marginHeight = Theme.EDGE;
    layout.horizontalSpacing = 2 * Theme.STEP;
    layout.verticalSpacing = 2 * Theme.STEP;
    setLayout(layout);
    heading("NAME");
    name = text("such as Keira", 3);
    name.addListener(SWT.Modify, e -> named());
    heading("FILE");
    file = text("a .yaml file", 1);
    file.addListener(SWT.Modify, e -> filed());
    new QuietButton(this, theme, this::browse).text("Choose\u2026")
        .hint("Choose a new file, or one to which the robot is added");
    QuietButton add = new QuietButton(this, theme, () -> {}).icon(Icon.PLUS).text("Open files")
        .hint("Add it to a configuration that is open");
    add.addListener(SWT.MouseUp, e -> openFiles(add));
    add.setEnabled(!open.isEmpty());
    heading("TEXT");
    preview = new StyledText(this, SWT.V_SCROLL | SWT.H_SCROLL | SWT.READ_ONLY | SWT.MULTI);
    preview.setFont(theme.font(Face.FIGURES));
    preview.setBackground(theme.color(Role.GROUND));
    preview.setForeground(theme.color(Role.DIM));
    preview.setMargins(Theme.EDGE, 2 * Theme.STEP, Theme.EDGE, 2 * Theme.STEP);
    preview.setLayoutData(new GridData(SWT.FILL, SWT.FILL, true, true, 3, 1));
    proposeFile();
  }

  /** Shows what will stand in the file; what is new in the colour of text. */
  void show(CompositionText text) {
    switch (text) {
      case CompositionText.Refused r -> preview.setText("");
      case CompositionText.Text t -> {
        preview.setText(t.whole());
        int first = t.line() - 1;
        int lines = (int) t.added().lines().count();
        int from = preview.getOffsetAtLine(first);
        int to =
            first + lines < preview.getLineCount() ? preview.getOffsetAtLine(first + lines) : preview.getCharCount();
        preview.setStyleRange(new StyleRange(from, to - from, theme.color(Role.TEXT), null));
        if (!t.isNew()) {
          preview.setLineBackground(first, Math.min(lines, preview.getLineCount() - first),
              theme.mix(Role.ACCENT, Role.GROUND, 0.12));
          preview.setTopIndex(Math.max(0, first - 3));
        }
      }
    }
  }

  private void named() {
    model.name(name.getText());
    if (!fileTyped) {
      proposeFile();
    }
    changed.run();
  }

  /** A file beside the others, named after the robot. */
  private void proposeFile() {
    String word =
        name.getText().strip().toLowerCase(java.util.Locale.ROOT).replaceAll("[^a-z0-9]+", "-").replaceAll("^-|-$", "");
    proposing = true;
    file.setText(model.file().resolveSibling((word.isEmpty() ? "robot" : word) + ".yaml").toString());
    proposing = false;
  }

  private void filed() {
    fileTyped |= !proposing;
    path(file.getText().strip()).ifPresent(model::file);
    if (!proposing) {
      changed.run();
    }
  }

  private static Optional<Path> path(String text) {
    try {
      return text.isEmpty() ? Optional.empty() : Optional.of(Path.of(text).toAbsolutePath().normalize());
    } catch (InvalidPathException e) {
      return Optional.empty();
    }
  }

  private void browse() {
    FileDialog dialog = new FileDialog(getShell(), SWT.SAVE);
    dialog.setText("Where the robot UI is written");
    dialog.setFilterPath(Optional.ofNullable(model.file().getParent()).map(Path::toString).orElse(""));
    dialog.setFileName(Optional.ofNullable(model.file().getFileName()).map(Path::toString).orElse("robot.yaml"));
    dialog.setFilterExtensions(new String[]{"*.yaml;*.yml"});
    dialog.setOverwrite(false);
    Optional.ofNullable(dialog.open()).ifPresent(file::setText);
  }

  private void openFiles(QuietButton below) {
    PopupMenu menu = new PopupMenu(below);
    open.forEach(p -> menu.push(p.toString(), () -> file.setText(p.toAbsolutePath().normalize().toString())));
    menu.openBelow(below);
  }

  @Override
  public boolean setFocus() {
    return !name.isDisposed() && name.setFocus();
  }

  private Text text(String message, int columns) {
    Composite frame = Boxes.ownColours(new Composite(this, SWT.NONE));
    frame.setBackground(theme.color(Role.GROUND));
    GridLayout inset = new GridLayout(1, false);
    inset.marginWidth = INSET;
    inset.marginHeight = Theme.STEP;
    frame.setLayout(inset);
    frame.setLayoutData(new GridData(SWT.FILL, SWT.CENTER, true, false, columns, 1));
    Text text = new Text(frame, SWT.SINGLE);
    text.setFont(theme.font(Face.BODY));
    text.setBackground(theme.color(Role.GROUND));
    text.setForeground(theme.color(Role.TEXT));
    text.setMessage(message);
    text.setLayoutData(new GridData(SWT.FILL, SWT.CENTER, true, false));
    return text;
  }

  private void heading(String words) {
    ShortenedLabel heading = new ShortenedLabel(this, theme, Face.SMALL_STRONG, Role.DIM, words);
    GridData data = new GridData(SWT.FILL, "TEXT".equals(words) ? SWT.TOP : SWT.CENTER, false, false);
    data.widthHint = 60;
    heading.setLayoutData(data);
  }
}
