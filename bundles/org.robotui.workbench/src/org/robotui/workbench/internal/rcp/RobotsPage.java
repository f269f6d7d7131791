package org.robotui.workbench.internal.rcp;

import org.eclipse.jface.preference.PreferencePage;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.ui.IWorkbench;
import org.eclipse.ui.IWorkbenchPreferencePage;
import org.robotui.workbench.internal.WorkbenchServices;
import org.robotui.workbench.internal.WorkbenchSession;
import org.robotui.workbench.internal.pane.WrittenPane;

/** What the configurations say of robots, among the preferences. */
public final class RobotsPage extends PreferencePage implements IWorkbenchPreferencePage {
  /** As in plugin.xml. */
  static final String ID = "org.robotui.workbench.preferences.robots";

  private static final int HEIGHT = 480;
  private static final int WIDTH = 820;

  private final WorkbenchSession session = WorkbenchServices.session();
  private String ruic = "";

  @Override
  public void init(IWorkbench platform) {
    noDefaultAndApplyButton();
  }

  /** The platform calls it when the page has been made. */
  @Override
  public void applyData(Object data) {
    ruic = data.toString();
  }

  @Override
  protected Control createContents(Composite parent) {
    Composite place = Trim.place(parent);
    new Rebuilt<>(place, session, (within, theme) -> new WrittenPane(within, theme, session.host(),
        session.configurations().background(), () -> ruic), pane -> {});
    GridData data = new GridData(GridData.FILL_BOTH);
    data.heightHint = HEIGHT;
    data.widthHint = WIDTH;
    place.setLayoutData(data);
    place.getDisplay().asyncExec(() -> widen(place));
    return place;
  }

  /** The platform makes its dialog as wide as its smallest page. */
  private static void widen(Composite place) {
    if (place.isDisposed() || place.getSize().x >= WIDTH) {
      return;
    }
    Shell shell = place.getShell();
    Rectangle screen = shell.getMonitor().getClientArea();
    Rectangle now = shell.getBounds();
    int width = Math.min(screen.width, now.width + WIDTH - place.getSize().x);
    int left = Math.clamp(now.x - (width - now.width) / 2, screen.x, screen.x + screen.width - width);
    shell.setBounds(left, now.y, width, now.height);
  }
}
