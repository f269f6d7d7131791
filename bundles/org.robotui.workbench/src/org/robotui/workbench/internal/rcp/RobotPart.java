package org.robotui.workbench.internal.rcp;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.ui.IViewPart;
import org.eclipse.ui.IWorkbenchPage;
import org.eclipse.ui.IWorkbenchWindow;
import org.eclipse.ui.part.ViewPart;
import org.robotui.api.host.ConfigChange;
import org.robotui.api.host.HostListener;
import org.robotui.api.host.Ruic;
import org.robotui.api.show.Subject;
import org.robotui.ui.Theme;
import org.robotui.workbench.internal.WorkbenchServices;
import org.robotui.workbench.internal.WorkbenchSession;
import org.robotui.workbench.internal.display.ShortcutsKey;
import org.robotui.workbench.internal.model.WindowModel;
import org.robotui.workbench.internal.dock.RobotArea;
import org.robotui.workbench.internal.dock.RuicSurface;

/** The one part that realises the layout of whatever RUIC its window shows. */
public final class RobotPart extends ViewPart {
  /** As in plugin.xml. */
  public static final String ID = "org.robotui.workbench.robot";

  private final WorkbenchSession session = WorkbenchServices.session();
  private WindowModel model;
  private Rebuilt<RobotArea> pane;

  /** The part of a window, where it has one. */
  public static Optional<RobotPart> in(IWorkbenchWindow window) {
    return Optional.ofNullable(window.getActivePage())
        .map((IWorkbenchPage page) -> page.findView(ID))
        .filter(RobotPart.class::isInstance)
        .map((IViewPart part) -> (RobotPart) part);
  }

  @Override
  public void createPartControl(Composite whole) {
    Composite parent = TimelineBelow.add(whole, session);
    model = session.model(getSite().getWorkbenchWindow());
    pane = new Rebuilt<>(parent, session, this::area, area -> {});
    List<Runnable> ends = List.of(
        model.onChange(this::show),
        session.listen(listener())::close,
        session.configurations().onChange(this::problems));
    parent.addListener(SWT.Dispose, e -> ends.forEach(Runnable::run));
    ShortcutsKey.listen(parent, () -> new WindowActions(session, getSite().getWorkbenchWindow()).shortcuts());
  }

  @Override
  public void setFocus() {
    pane.control().setFocus();
  }

  /** The area, for tests and commands. */
  public RobotArea area() {
    return pane.control();
  }

  /** Takes out the view that took part in a failure; false where none did. */
  boolean blame(Throwable failure) {
    return surface().filter(s -> s.blame(failure)).isPresent();
  }

  private RobotArea area(Composite parent, Theme theme) {
    RobotArea area = new RobotArea(parent, theme, session::history,
        new WindowActions(session, getSite().getWorkbenchWindow()));
    area.problems(session.configurations().problems());
    area.lock(model.isOperated());
    area.show(model.selected());
    return area;
  }

  private HostListener listener() {
    return new HostListener() {
      @Override
      public void ruicChanged(String ruic) {
        if (isShown(ruic)) {
          show();
        }
      }

      @Override
      public void configurationChanged(ConfigChange change) {
        change.steps().forEach(step -> {
          if (step instanceof ConfigChange.Step.Exchanged e && isShown(e.ruic())) {
            new WindowActions(session, getSite().getWorkbenchWindow()).exchange(e.ruic(), e.wanted());
          }
        });
      }

      @Override
      public void viewWanted(String ruic, String uic, String showing, Subject subject) {
        if (isShown(ruic)) {
          getSite().getPage().bringToTop(RobotPart.this);
          surface().ifPresent(s -> s.view(uic, showing, subject));
        }
      }

      @Override
      public void frameReady(String ruic, String uic) {
        if (isShown(ruic)) {
          surface().ifPresent(s -> s.refresh(uic));
        }
      }
    };
  }

  private boolean isShown(String ruic) {
    return model.selected().map(Ruic::name).filter(ruic::equals).isPresent();
  }

  private Optional<RuicSurface> surface() {
    return Optional.ofNullable(pane).map(Rebuilt::control).filter(c -> !c.isDisposed()).flatMap(RobotArea::surface);
  }

  private void show() {
    if (!pane.control().isDisposed()) {
      pane.control().lock(model.isOperated());
      pane.control().show(model.selected());
      session.refresh();
    }
  }

  private void problems() {
    if (!pane.control().isDisposed()) {
      pane.control().problems(session.configurations().problems());
      pane.control().show(model.selected()); // what is read now may have no robot
    }
  }
}
