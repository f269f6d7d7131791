package org.robotui.workbench.internal.rcp;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.function.Consumer;
import org.eclipse.jface.dialogs.MessageDialog;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.ui.IWorkbenchWindow;
import org.eclipse.ui.PlatformUI;
import org.eclipse.ui.application.IWorkbenchConfigurer;
import org.eclipse.ui.application.IWorkbenchWindowConfigurer;
import org.eclipse.ui.application.WorkbenchAdvisor;
import org.eclipse.ui.application.WorkbenchWindowAdvisor;
import org.robotui.api.config.WriteFailure;
import org.robotui.api.host.FileOutcome;
import org.robotui.workbench.internal.Suspects;
import org.robotui.workbench.internal.WorkbenchServices;
import org.robotui.workbench.internal.WorkbenchSession;
import org.robotui.workbench.internal.display.Screenshot;
import org.robotui.workbench.internal.dock.ViewWindow;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** How the workbench starts, and what it does with failures on the display thread. */
public final class RobotWorkbenchAdvisor extends WorkbenchAdvisor {
  private static final Logger LOG = LoggerFactory.getLogger(RobotWorkbenchAdvisor.class);

  private final WorkbenchSession session;
  private final Runnable started;
  private final Consumer<FileOutcome> opened;
  private final Suspects suspects;
  private final boolean asks;

  /**
   * For a session; {@code started} runs when the window stands, with the robots that were asked for, and perhaps again;
   * {@code opened} is told what came of the recordings that the command line names.
   */
  public RobotWorkbenchAdvisor(WorkbenchSession session, Runnable started, Consumer<FileOutcome> opened) {
    this.session = session;
    this.started = started;
    this.opened = opened;
    suspects = new Suspects(session.state().folder());
    asks = session.arguments().isAttended() && suspects.exist();
  }

  /** Has robots start while the platform makes the window, unless the user is to be asked something before. */
  public void startRobots() {
    if (!asks) {
      load();
    }
  }

  @Override
  public void initialize(IWorkbenchConfigurer configurer) {
    configurer.setSaveAndRestore(false);
  }

  @Override
  public String getInitialWindowPerspectiveId() {
    return RobotPerspective.ID;
  }

  @Override
  public String getMainPreferencePageId() {
    return GeneralPage.ID;
  }

  @Override
  public WorkbenchWindowAdvisor createWorkbenchWindowAdvisor(IWorkbenchWindowConfigurer configurer) {
    return new RobotWindowAdvisor(configurer, session);
  }

  @Override
  public void postStartup() {
    new PlatformKeys(PlatformUI.getWorkbench(), session.keys()).follow();
    ViewWindowKeys.follow(PlatformUI.getWorkbench(), session.keys());
    PreferencePages.tidy(PlatformUI.getWorkbench().getPreferenceManager());
    if (asks) {
      suspects.judge(RobotWorkbenchAdvisor::leaveOut).forEach(WorkbenchServices::disable);
      load();
    }
    begin();
    session.arguments().screenshot().ifPresent(file -> after(session.arguments().after(), () -> picture(file)));
    session.arguments().limit().ifPresent(limit -> after(limit, RobotWorkbenchAdvisor::close));
  }

  private void load() {
    session.arguments().configurations().forEach(session.configurations()::load);
    session.arguments().files().forEach(file -> session.configurations().open(file, opened));
  }

  /** Views that are made for the first time take long, and nothing moves before they are there. */
  private void begin() {
    AskedWindows windows = new AskedWindows(session);
    windows.open(PlatformUI.getWorkbench());
    session.onLoaded(() -> windows.open(PlatformUI.getWorkbench()));
    session.onLoaded(started);
    if (session.configurations().areRead()) {
      started.run();
    }
  }

  /** A view that throws while it paints or takes input is taken out; the workbench goes on. */
  @Override
  public void eventLoopException(Throwable exception) {
    boolean blamed = false;
    for (IWorkbenchWindow window : PlatformUI.getWorkbench().getWorkbenchWindows()) {
      blamed |= RobotPart.in(window).filter(part -> part.blame(exception)).isPresent();
    }
    if (!blamed) {
      LOG.error("failure on the display thread", exception);
    }
  }

  private static boolean leaveOut(String bundle) {
    String question = "In the last run the bundle " + bundle
        + " kept the window from answering, so that the robots were stopped. Start without it this time?";
    return MessageDialog.open(MessageDialog.QUESTION, PlatformUI.getWorkbench().getWorkbenchWindows()[0].getShell(),
        "Start without a bundle", question, SWT.NONE, "Start without it", "Start with it") == 0;
  }

  /** Closes dialogs first: one that is open would keep the workbench. */
  private static void close() {
    Arrays.stream(Display.getCurrent().getShells())
        .filter(shell -> !shell.isDisposed() && shell.getParent() != null && !ViewWindow.isOne(shell))
        .forEach(Shell::close);
    PlatformUI.getWorkbench().close();
  }

  private static void after(Duration delay, Runnable action) {
    Display.getCurrent().timerExec((int) delay.toMillis(), action);
  }

  private static void picture(Path file) {
    try {
      Screenshot.save(PlatformUI.getWorkbench().getWorkbenchWindows()[0].getShell(), file);
    } catch (IOException e) {
      LOG.error("{} could not be written: {}", file, WriteFailure.reason(e));
    }
  }
}
