package org.robotui.workbench.internal.rcp;

import java.util.List;
import org.eclipse.jface.action.Action;
import org.eclipse.jface.action.ActionContributionItem;
import org.eclipse.jface.action.IContributionItem;
import org.eclipse.ui.IWorkbenchWindow;
import org.eclipse.ui.actions.CompoundContributionItem;
import org.eclipse.ui.menus.IWorkbenchContribution;
import org.eclipse.ui.services.IServiceLocator;
import org.robotui.api.command.Authority;
import org.robotui.api.host.Ruic;
import org.robotui.workbench.internal.WorkbenchServices;
import org.robotui.workbench.internal.WorkbenchSession;

/** In the menu Robot: stops or releases each robot of the window, by name. */
public final class StopItems extends CompoundContributionItem implements IWorkbenchContribution {
  private IServiceLocator locator;

  @Override
  public void initialize(IServiceLocator serviceLocator) {
    locator = serviceLocator;
  }

  @Override
  protected IContributionItem[] getContributionItems() {
    WorkbenchSession session = WorkbenchServices.session();
    List<Authority> authorities =
        session.model(locator.getService(IWorkbenchWindow.class)).selected().map(Ruic::authorities).orElse(List.of());
    return authorities.stream().map(authority -> new ActionContributionItem(item(session, authority)))
        .toArray(IContributionItem[]::new);
  }

  private static Action item(WorkbenchSession session, Authority authority) {
    boolean stopped = authority.stoppedBy().isPresent();
    return new Action((stopped ? "Release " : "Stop ") + authority.robot()) {
      @Override
      public void run() {
        if (stopped) {
          session.release(List.of(authority));
        } else {
          session.stop(List.of(authority));
        }
      }
    };
  }
}
