package org.robotui.workbench.internal.rcp;

import org.eclipse.jface.action.Action;
import org.eclipse.jface.action.ActionContributionItem;
import org.eclipse.jface.action.IContributionItem;
import org.eclipse.ui.IWorkbenchWindow;
import org.eclipse.ui.actions.CompoundContributionItem;
import org.eclipse.ui.menus.IWorkbenchContribution;
import org.eclipse.ui.services.IServiceLocator;
import org.robotui.api.host.Ruic;
import org.robotui.workbench.internal.WorkbenchServices;
import org.robotui.workbench.internal.WorkbenchSession;

/** In the menu Robot: closes the recording that the window shows. */
public final class CloseItems extends CompoundContributionItem implements IWorkbenchContribution {
  private IServiceLocator locator;

  @Override
  public void initialize(IServiceLocator serviceLocator) {
    locator = serviceLocator;
  }

  @Override
  protected IContributionItem[] getContributionItems() {
    WorkbenchSession session = WorkbenchServices.session();
    return session.model(locator.getService(IWorkbenchWindow.class)).selected().stream()
        .flatMap(ruic -> FileChoice.closing(session, ruic.name()).stream()
            .map(label -> new ActionContributionItem(item(label, ruic))))
        .toArray(IContributionItem[]::new);
  }

  private static Action item(String label, Ruic ruic) {
    return new Action(label) {
      @Override
      public void run() {
        ruic.remove();
      }
    };
  }
}
