package org.robotui.workbench.internal.rcp;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.eclipse.core.runtime.Platform;
import org.eclipse.jface.action.Action;
import org.eclipse.jface.action.ActionContributionItem;
import org.eclipse.jface.action.IContributionItem;
import org.eclipse.jface.dialogs.MessageDialog;
import org.eclipse.swt.program.Program;
import org.eclipse.ui.IWorkbenchWindow;
import org.eclipse.ui.actions.CompoundContributionItem;
import org.eclipse.ui.menus.IWorkbenchContribution;
import org.eclipse.ui.services.IServiceLocator;
import org.robotui.workbench.internal.dock.RuicSurface;

/** In the menu Help: the documentation, and its page about the view that had the focus last. */
public final class HelpItems extends CompoundContributionItem implements IWorkbenchContribution {
  private IServiceLocator locator;

  @Override
  public void initialize(IServiceLocator serviceLocator) {
    locator = serviceLocator;
  }

  @Override
  protected IContributionItem[] getContributionItems() {
    Documentation documentation = new Documentation(installation(), Program::launch);
    IWorkbenchWindow window = locator.getService(IWorkbenchWindow.class);
    List<IContributionItem> items = new ArrayList<>();
    items.add(item(window, documentation, "Documentation", documentation.index()));
    RobotPart.in(window).flatMap(part -> part.area().surface()).flatMap(RuicSurface::lastFocused)
        .ifPresent(view -> documentation.view(view.type())
            .ifPresent(page -> items
                .add(item(window, documentation, "Documentation of the View '" + view.title() + "'", page))));
    return items.toArray(IContributionItem[]::new);
  }

  /** Where the product lies. */
  static Path installation() {
    // The platform does not escape what stands in its addresses.
    return Path.of(Platform.getInstallLocation().getURL().getPath());
  }

  private static ActionContributionItem item(IWorkbenchWindow window, Documentation documentation, String label,
      Path page) {
    return new ActionContributionItem(new Action(label) {
      @Override
      public void run() {
        documentation.open(page)
            .ifPresent(why -> MessageDialog.openInformation(window.getShell(), "Documentation", why));
      }
    });
  }
}
