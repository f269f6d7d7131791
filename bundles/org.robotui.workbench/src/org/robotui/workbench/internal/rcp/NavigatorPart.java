package org.robotui.workbench.internal.rcp;

import java.util.Optional;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.ui.IWorkbenchWindow;
import org.eclipse.ui.part.ViewPart;
import org.robotui.api.host.Ruic;
import org.robotui.workbench.internal.WorkbenchServices;
import org.robotui.workbench.internal.WorkbenchSession;
import org.robotui.workbench.internal.model.Overview;
import org.robotui.workbench.internal.pane.Navigator;

/** The robots at the left of a window. */
public final class NavigatorPart extends ViewPart {
  /** As in plugin.xml. */
  static final String ID = "org.robotui.workbench.navigator";

  private final WorkbenchSession session = WorkbenchServices.session();
  private Rebuilt<Navigator> pane;

  @Override
  public void createPartControl(Composite parent) {
    IWorkbenchWindow window = getSite().getWorkbenchWindow();
    WindowActions actions = new WindowActions(session, window);
    pane = new Rebuilt<>(parent, session, (p, theme) -> new Navigator(p, theme, actions), this::show);
  }

  @Override
  public void setFocus() {
    pane.control().setFocus();
  }

  private void show(Navigator navigator) {
    Overview now = session.overview();
    Optional<Ruic> selected = session.model(getSite().getWorkbenchWindow()).selected();
    navigator.show(now.robots(), selected.map(Ruic::name),
        selected.map(now::detail).orElse(Overview.Detail.NONE).ports());
  }
}
