package org.robotui.workbench.internal.rcp;

import org.eclipse.jface.action.Action;
import org.eclipse.jface.action.ActionContributionItem;
import org.eclipse.jface.action.IAction;
import org.eclipse.jface.action.IContributionItem;
import org.eclipse.ui.IWorkbenchWindow;
import org.eclipse.ui.actions.CompoundContributionItem;
import org.eclipse.ui.menus.IWorkbenchContribution;
import org.eclipse.ui.services.IServiceLocator;
import org.robotui.api.host.Arranging.ViewChoice;
import org.robotui.workbench.internal.dock.RuicSurface;

/**
 * In the menu View: the views of the robot that the window shows; those that are open are checked. Choosing one brings
 * it to the front, and opens it where it is closed.
 */
public final class ViewItems extends CompoundContributionItem implements IWorkbenchContribution {
  private IServiceLocator locator;

  @Override
  public void initialize(IServiceLocator serviceLocator) {
    locator = serviceLocator;
  }

  @Override
  protected IContributionItem[] getContributionItems() {
    return WindowActions.layoutOf(locator.getService(IWorkbenchWindow.class)).stream()
        .flatMap(layout -> layout.surface().docking().arranging().views().stream()
            .map(view -> new ActionContributionItem(item(layout, view, failed(layout.surface(), view)))))
        .toArray(IContributionItem[]::new);
  }

  private static boolean failed(RuicSurface surface, ViewChoice view) {
    return surface.views().stream().anyMatch(open -> open.id().equals(view.id()) && open.failed());
  }

  private static Action item(LayoutActions layout, ViewChoice view, boolean failed) {
    Action action = new Action(view.title() + (failed ? " (does not work)" : ""), IAction.AS_CHECK_BOX) {
      @Override
      public void run() {
        layout.show(view);
      }
    };
    action.setChecked(view.open());
    return action;
  }
}
