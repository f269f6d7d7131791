package org.robotui.workbench.internal.rcp;

import java.util.Arrays;
import java.util.List;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.ui.IWorkbenchWindow;
import org.eclipse.ui.application.IWorkbenchWindowConfigurer;
import org.eclipse.ui.application.WorkbenchWindowAdvisor;
import org.robotui.workbench.internal.WorkbenchSession;
import org.robotui.workbench.internal.model.WindowModel;
import org.robotui.workbench.internal.model.WindowPlaces;

/** A window: nothing of the platform's chrome, our bar at the top and our line at the bottom. */
final class RobotWindowAdvisor extends WorkbenchWindowAdvisor {
  private static final Point USUAL_SIZE = new Point(1600, 980);

  private static final int LATE_MILLIS = 4000;

  private final WorkbenchSession session;

  RobotWindowAdvisor(IWorkbenchWindowConfigurer configurer, WorkbenchSession session) {
    super(configurer);
    this.session = session;
  }

  @Override
  public void preWindowOpen() {
    IWorkbenchWindowConfigurer configurer = getWindowConfigurer();
    Rectangle screen = configurer.getWindow().getWorkbench().getDisplay().getPrimaryMonitor().getClientArea();
    configurer.setInitialSize(new Point(Math.min(USUAL_SIZE.x, screen.width), Math.min(USUAL_SIZE.y, screen.height)));
    configurer.setTitle("RobotUI");
    configurer.setShowMenuBar(false);
    configurer.setShowCoolBar(false);
    configurer.setShowPerspectiveBar(false);
    configurer.setShowStatusLine(false);
    configurer.setShowProgressIndicator(false);
  }

  @Override
  public void postWindowCreate() {
    IWorkbenchWindow window = getWindowConfigurer().getWindow();
    place(window);
    Trim.add(window);
    // Most of what the platform makes late comes after this call and before the window is shown.
    window.getShell().addListener(SWT.Show, e -> Trim.tidy(window));
    // The platform has restored the theme of the product by now; ours is the user's.
    session.look().apply();
  }

  @Override
  public void postWindowOpen() {
    IWorkbenchWindow window = getWindowConfigurer().getWindow();
    Shell shell = window.getShell();
    name(shell);
    new FileChoice(session, window).takeDrops();
    // What the platform makes late comes after this call, on a busy machine some seconds.
    Runnable tidy = () -> {
      if (!shell.isDisposed()) {
        Trim.tidy(window);
      }
    };
    shell.getDisplay().asyncExec(tidy);
    shell.getDisplay().timerExec(LATE_MILLIS, tidy);
  }

  /** A window more does not cover another one exactly. */
  private static void place(IWorkbenchWindow window) {
    Shell shell = window.getShell();
    List<Rectangle> taken = Arrays.stream(window.getWorkbench().getWorkbenchWindows()).map(IWorkbenchWindow::getShell)
        .filter(other -> other != null && other != shell && other.isVisible()).map(Shell::getBounds).toList();
    if (!taken.isEmpty()) {
      shell.setBounds(WindowPlaces.next(shell.getDisplay().getPrimaryMonitor().getClientArea(), taken));
    }
  }

  /** Windows are told apart, by the user and by the desktop, by the robot that they show. */
  private void name(Shell shell) {
    WindowModel model = session.model(getWindowConfigurer().getWindow());
    Runnable title = () -> {
      if (!shell.isDisposed()) {
        getWindowConfigurer().setTitle(model.title());
      }
    };
    model.onChange(title);
    model.onFront(() -> {
      shell.setMinimized(false);
      shell.forceActive();
    });
    title.run();
  }

  @Override
  public void postWindowClose() {
    IWorkbenchWindow window = getWindowConfigurer().getWindow();
    session.closed(window);
  }
}
