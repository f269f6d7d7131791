package org.robotui.workbench.internal.rcp;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.eclipse.jface.dialogs.MessageDialog;
import org.eclipse.swt.program.Program;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.ui.IWorkbenchWindow;
import org.robotui.ui.Theme;
import org.robotui.workbench.internal.WorkbenchSession;
import org.robotui.workbench.internal.pane.WelcomeDialog;
import org.robotui.workbench.internal.pane.WelcomePane;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** What the welcome page of a window does, and whether it is wanted. Display thread only. */
final class WelcomeActions implements WelcomePane.Actions {
  private static final Logger LOG = LoggerFactory.getLogger(WelcomeActions.class);
  private static final String WANTED = "welcome";
  private static final String HOME = "robotui.home";
  private static final String TUTORIAL = "docs/extending.html";

  private final WorkbenchSession session;
  private final IWorkbenchWindow window;
  private final WindowActions actions;
  private final Documentation documentation = new Documentation(HelpItems.installation(), Program::launch);

  WelcomeActions(WorkbenchSession session, IWorkbenchWindow window, WindowActions actions) {
    this.session = session;
    this.window = window;
    this.actions = actions;
  }

  /** Whether a window without a robot shows it: not while one may still come. */
  boolean isWanted() {
    return isChosen() && session.host().ruics().isEmpty() && session.configurations().areRead();
  }

  private boolean isChosen() {
    return !session.state().get(WANTED).filter("false"::equals).isPresent();
  }

  WelcomePane pane(Composite parent, Theme theme) {
    return new WelcomePane(parent, theme, session.recent().list(), isChosen(), this);
  }

  /** Shows it over the window. */
  void dialog() {
    new WelcomeDialog(window.getShell(), session.look().theme(), session.recent().list(), isChosen(), this).open();
  }

  /** By the program that starts RobotUI, which also starts and ends the simulated robots. */
  @Override
  public void demo() {
    Path program = Path.of(System.getProperty(HOME, "")).resolve("robotui");
    if (!Files.isExecutable(program)) {
      say("The demo is started by the program 'robotui', which is not in this installation: " + program);
      return;
    }
    try {
      new ProcessBuilder(program.toString(), "run").redirectOutput(ProcessBuilder.Redirect.DISCARD)
          .redirectError(ProcessBuilder.Redirect.DISCARD).start();
      session.alerts().pass("The demo starts in a window of its own.");
    } catch (IOException e) {
      LOG.warn("The demo cannot be started by {}", program, e);
      say("The demo cannot be started: " + e.getMessage());
    }
  }

  @Override
  public void create() {
    actions.create();
  }

  @Override
  public void open() {
    actions.open();
  }

  @Override
  public void recording() {
    new FileChoice(session, window).choose();
  }

  @Override
  public void open(Path file) {
    new FileChoice(session, window).open(file);
  }

  @Override
  public void software() {
    actions.software();
  }

  @Override
  public void documentation() {
    documentation.open(documentation.index()).ifPresent(this::say);
  }

  @Override
  public void tutorial() {
    documentation.open(documentation.index().resolveSibling(TUTORIAL)).ifPresent(this::say);
  }

  @Override
  public void wanted(boolean wanted) {
    session.state().put(WANTED, Boolean.toString(wanted));
  }

  private void say(String words) {
    MessageDialog.openInformation(window.getShell(), "Welcome", words);
  }
}
