package org.robotui.workbench.internal.rcp;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Monitor;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.ui.IWorkbench;
import org.eclipse.ui.IWorkbenchWindow;
import org.eclipse.ui.WorkbenchException;
import org.robotui.api.host.WindowConfig;
import org.robotui.workbench.internal.WorkbenchSession;
import org.robotui.workbench.internal.model.WindowPlaces;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Opens the windows that configurations ask for and places them; where the user has moved or sized one in an earlier
 * run, it goes there. Display thread only.
 */
final class AskedWindows {
  private static final Logger LOG = LoggerFactory.getLogger(AskedWindows.class);
  private static final String KEY = "window.";

  private final WorkbenchSession session;
  private boolean done;

  AskedWindows(WorkbenchSession session) {
    this.session = session;
  }

  /** Opens them once all configurations of the start are read; later calls do nothing. */
  void open(IWorkbench workbench) {
    if (done || !session.configurations().areRead()) {
      return;
    }
    done = true;
    List<WindowConfig> asked = session.windows().asked();
    if (asked.isEmpty() || workbench.getWorkbenchWindowCount() == 0) {
      return;
    }
    List<Shell> shells = shells(workbench, asked.size());
    Rectangle screen = shells.getFirst().getDisplay().getPrimaryMonitor().getClientArea();
    List<Rectangle> places = WindowPlaces.of(screen, asked.stream().map(WindowConfig::weight).toList());
    // The first last: it stays in front and takes the keys.
    for (int i = shells.size() - 1; i >= 0; i--) {
      place(shells.get(i), asked.get(i), asked.size() == 1 ? Optional.empty() : Optional.of(places.get(i)));
    }
    shells.getFirst().setActive();
  }

  /** Each selects the RUIC that it is for as it opens; the first is there already. */
  private List<Shell> shells(IWorkbench workbench, int count) {
    List<Shell> shells = new ArrayList<>(List.of(workbench.getWorkbenchWindows()[0].getShell()));
    try {
      while (shells.size() < count) {
        IWorkbenchWindow window = workbench.openWorkbenchWindow(RobotPerspective.ID, null);
        shells.add(window.getShell());
      }
    } catch (WorkbenchException e) {
      LOG.error("a window could not be opened", e);
    }
    return shells;
  }

  private void place(Shell shell, WindowConfig window, Optional<Rectangle> usual) {
    String key = KEY + window.file().toAbsolutePath().normalize() + "#" + window.ruic();
    Optional<String> kept = session.state().get(key);
    Optional<Rectangle> former = kept.flatMap(KeptPlace::bounds).filter(b -> WindowPlaces.isSeen(b, screens(shell)));
    former.or(() -> usual).ifPresent(shell::setBounds);
    shell.setMaximized(kept.filter(KeptPlace.MAXIMIZED::equals).isPresent());
    if (session.arguments().isAttended()) {
      KeptPlace.follow(shell, place -> session.state().put(key, place));
    }
  }

  private static List<Rectangle> screens(Shell shell) {
    return Arrays.stream(shell.getDisplay().getMonitors()).map(Monitor::getClientArea).toList();
  }
}
