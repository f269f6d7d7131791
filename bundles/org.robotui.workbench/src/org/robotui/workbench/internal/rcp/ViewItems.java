package org.robotui.workbench.internal.rcp;

import org.eclipse.jface.action.Action;
import org.eclipse.jface.action.ActionContributionItem;
import org.eclipse.jface.action.IAction;
import org.eclipse.jface.action.IContributionItem;
import org.eclipse.ui.IWorkbenchWindow;
import org.eclipse.ui.actions.CompoundContributionItem;
import org.eclipse.ui.menus.IWorkbenchContribution;
import org.eclipse.ui.services.IServiceLocator;
import org.robotui.workbench.internal.pane.RuicSurface;
import org.robotui.workbench.internal.pane.ViewEntry;

/** In the menu View: the views of the robot that the window shows; those that are seen are checked. */
public final class ViewItems extends CompoundContributionItem implements IWorkbenchContribution {
  private IServiceLocator locator;

  @Override
  public void initialize(IServiceLocator serviceLocator) {
    locator = serviceLocator;
  }

  @Override
  protected IContributionItem[] getContributionItems() {
    return RobotPart.in(locator.getService(IWorkbenchWindow.class)).flatMap(part -> part.area().surface()).stream()
        .flatMap(surface -> surface.views().stream().map(view -> new ActionContributionItem(item(surface, view))))
        .toArray(IContributionItem[]::new);
  }

  private static Action item(RuicSurface surface, ViewEntry view) {
    Action action = new Action(view.label(), IAction.AS_CHECK_BOX) {
      @Override
      public void run() {
        surface.reveal(view.id());
      }
    };
    action.setChecked(view.seen());
    return action;
  }
}
