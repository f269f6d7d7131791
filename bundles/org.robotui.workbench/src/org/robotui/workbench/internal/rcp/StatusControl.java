package org.robotui.workbench.internal.rcp;

import jakarta.annotation.PostConstruct;
import org.eclipse.e4.ui.model.application.ui.basic.MWindow;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.ui.IWorkbenchWindow;
import org.robotui.workbench.internal.WorkbenchServices;
import org.robotui.workbench.internal.WorkbenchSession;
import org.robotui.workbench.internal.model.Overview;
import org.robotui.workbench.internal.model.WindowModel;
import org.robotui.workbench.internal.pane.StatusBar;

/** The line at the bottom of a window, in the platform's trim. */
public final class StatusControl {
  private final WorkbenchSession session = WorkbenchServices.session();

  /** Called by the platform. */
  @PostConstruct
  void create(Composite parent, MWindow model) {
    IWorkbenchWindow window = model.getContext().get(IWorkbenchWindow.class);
    new Rebuilt<>(Trim.place(parent), session, (bar, theme) -> new StatusBar(bar, theme, this::dismiss),
        bar -> show(bar, session.model(window)));
  }

  private void show(StatusBar bar, WindowModel model) {
    bar.show(model.selected().map(session.overview()::detail).orElse(Overview.Detail.NONE).status());
    bar.alert(session.alerts().text());
  }

  private void dismiss() {
    session.alerts().dismiss();
    session.refresh();
  }
}
