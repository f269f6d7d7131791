package org.robotui.workbench.internal.rcp;

import jakarta.annotation.PostConstruct;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.eclipse.e4.ui.model.application.ui.basic.MWindow;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.ui.IWorkbenchWindow;
import org.robotui.api.host.Ruic;
import org.robotui.api.link.LinkState;
import org.robotui.ui.Theme;
import org.robotui.workbench.internal.WorkbenchServices;
import org.robotui.workbench.internal.WorkbenchSession;
import org.robotui.workbench.internal.model.Lease;
import org.robotui.workbench.internal.model.Overview;
import org.robotui.workbench.internal.model.RecordWords;
import org.robotui.workbench.internal.model.WindowModel;
import org.robotui.workbench.internal.pane.Menus;
import org.robotui.workbench.internal.pane.TopBar;

/** The bar of a window, in the platform's trim. */
public final class TopControl {
  private final WorkbenchSession session = WorkbenchServices.session();

  /** Called by the platform. */
  @PostConstruct
  void create(Composite parent, MWindow model) {
    IWorkbenchWindow window = model.getContext().get(IWorkbenchWindow.class);
    new Rebuilt<>(Trim.place(parent), session, (p, theme) -> bar(p, theme, window),
        bar -> show(bar, session.model(window)));
  }

  private TopBar bar(Composite parent, Theme theme, IWorkbenchWindow window) {
    return new TopBar(parent, theme, Menus.ALL, new WindowActions(session, window));
  }

  private void show(TopBar bar, WindowModel model) {
    bar.operated(model.isOperated());
    bar.searchKeys(session.keys().text("search"));
    Optional<Ruic> ruic = model.selected();
    LinkState link = ruic.map(session.overview()::detail).orElse(Overview.Detail.NONE).link();
    bar.recording(WorkbenchServices.recorder().map(recorder -> RecordWords.of(recorder.state(), Instant.now())));
    bar.show(Lease.of(ruic.map(Ruic::authorities).orElse(List.of()), link, session.user()), session.stops());
  }
}
