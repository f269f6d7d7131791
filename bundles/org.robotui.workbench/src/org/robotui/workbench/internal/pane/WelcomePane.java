package org.robotui.workbench.internal.pane;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Composite;
import org.robotui.ui.Face;
import org.robotui.ui.Icon;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.CheckBox;
import org.robotui.ui.control.QuietButton;

/** What one can begin with: a demo, a file, a robot, more software, something to read. Display thread only. */
public final class WelcomePane extends Composite {
  /** What can be begun. */
  public interface Actions {
    /** Starts simulated robots with a window of their own. */
    void demo();

    /** Connects to a robot that has no configuration. */
    void create();

    /** Lets the user choose a configuration. */
    void open();

    /** Lets the user choose a recording. */
    void recording();

    /** Opens what was opened before. */
    void open(Path file);

    /** Installs features. */
    void software();

    /** Shows the documentation. */
    void documentation();

    /** Shows how an own view is written. */
    void tutorial();

    /** Whether this is shown while there is no robot. */
    void wanted(boolean wanted);
  }

  /** Something that can be begun. */
  private record Beginning(Icon icon, String label, String help, Runnable action) {}

  private static final int WIDTH = 560;
  private static final int LABEL = 210;

  private final Theme theme;
  private final Composite middle;
  private QuietButton first;
  private boolean wanted;

  /**
   * Makes the page.
   *
   * @param recent what was opened before, the last one first
   * @param wanted whether it is shown while there is no robot
   */
  public WelcomePane(Composite parent, Theme theme, List<Path> recent, boolean wanted, Actions actions) {
    super(parent, SWT.NONE);
    this.theme = theme;
    this.wanted = wanted;
    setBackground(theme.color(Role.PANEL));
    setLayout(Boxes.grid(1));
    middle = Boxes.panel(this, theme, 1);
    GridData place = new GridData(SWT.CENTER, SWT.CENTER, true, true);
    place.widthHint = WIDTH;
    middle.setLayoutData(place);
    ((GridLayout) middle.getLayout()).verticalSpacing = Theme.STEP;
    ((GridLayout) middle.getLayout()).marginHeight = 2 * Theme.EDGE;
    words(Face.TITLE, Role.TEXT, "Welcome to RobotUI");
    words(Face.BODY, Role.DIM, "One workbench for robots of any framework. What do you want to begin with?");
    robots(actions);
    if (!recent.isEmpty()) {
      heading("OPENED BEFORE");
      recent.forEach(file -> begin(new Beginning(icon(file), file.getFileName().toString(),
          Optional.ofNullable(file.getParent()).map(Path::toString).orElse(""), () -> actions.open(file))));
    }
    heading("MORE");
    begin(new Beginning(Icon.PLUS, "Install Software\u2026", "Views and robot interfaces from an update site",
        actions::software));
    begin(new Beginning(Icon.TEXT, "Documentation", "All views, frameworks and settings", actions::documentation));
    begin(new Beginning(Icon.TEXT, "Write Your Own View", "A tutorial on the robot of the demo", actions::tutorial));
    choice(actions);
  }

  private void robots(Actions actions) {
    heading("A ROBOT");
    first =
        begin(new Beginning(Icon.PLAY, "Start the Demo", "Simulated robots, in a window of their own", actions::demo));
    begin(new Beginning(Icon.LINK, "Connect to a Robot\u2026", "Finds out what it offers and writes its configuration",
        actions::create));
    begin(new Beginning(Icon.LAYERS, "Open Configuration\u2026", "A file that says which robots and views there are",
        actions::open));
    begin(
        new Beginning(Icon.LOOP, "Open Recording\u2026", "MCAP, bags of ROS, logs of other frameworks",
            actions::recording));
  }

  private static Icon icon(Path file) {
    return file.toString().endsWith(".yaml") || file.toString().endsWith(".yml") ? Icon.LAYERS : Icon.LOOP;
  }

  private void words(Face face, Role role, String text) {
    new ShortenedLabel(middle, theme, face, role, text).setLayoutData(Boxes.line());
  }

  private void heading(String text) {
    ShortenedLabel label = new ShortenedLabel(middle, theme, Face.SMALL_STRONG, Role.DIM, text);
    GridData data = Boxes.line();
    data.verticalIndent = 2 * Theme.STEP;
    label.setLayoutData(data);
  }

  private QuietButton begin(Beginning what) {
    Composite line = Boxes.panel(middle, theme, 2);
    line.setLayoutData(Boxes.line());
    ((GridLayout) line.getLayout()).horizontalSpacing = Theme.EDGE;
    QuietButton button =
        new QuietButton(line, theme, what.action()).icon(what.icon()).text(what.label()).checked(true)
            .hint(what.help());
    GridData width = Boxes.middle();
    width.widthHint = LABEL;
    button.setLayoutData(width);
    new ShortenedLabel(line, theme, Face.BODY, Role.DIM, what.help())
        .setLayoutData(new GridData(SWT.FILL, SWT.CENTER, true, false));
    return button;
  }

  private void choice(Actions actions) {
    Composite line = Boxes.panel(middle, theme, 2);
    GridData data = Boxes.line();
    data.verticalIndent = Theme.EDGE;
    line.setLayoutData(data);
    String words = "Show this page while no robot is open";
    CheckBox[] box = new CheckBox[1];
    box[0] = new CheckBox(line, theme, words, () -> {
      wanted = !wanted;
      box[0].show(wanted);
      actions.wanted(wanted);
    });
    box[0].show(wanted);
    GridData square = Boxes.middle();
    square.widthHint = CheckBox.HEIGHT;
    square.heightHint = CheckBox.HEIGHT;
    box[0].control().setLayoutData(square);
    new ShortenedLabel(line, theme, Face.BODY, Role.DIM, words)
        .setLayoutData(new GridData(SWT.FILL, SWT.CENTER, true, false));
  }

  @Override
  public boolean setFocus() {
    return !first.isDisposed() && first.setFocus();
  }
}
