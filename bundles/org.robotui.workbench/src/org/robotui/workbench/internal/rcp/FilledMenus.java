package org.robotui.workbench.internal.rcp;

import java.util.List;
import java.util.Optional;
import org.eclipse.e4.ui.model.application.ui.menu.MMenu;
import org.eclipse.e4.ui.model.application.ui.menu.MMenuElement;
import org.eclipse.e4.ui.model.application.ui.menu.MMenuFactory;
import org.eclipse.e4.ui.workbench.renderers.swt.MenuManagerRenderer;
import org.eclipse.e4.ui.workbench.swt.factories.IRendererFactory;
import org.eclipse.jface.action.IContributionItem;
import org.eclipse.jface.action.MenuManager;
import org.eclipse.ui.menus.IMenuService;
import org.eclipse.ui.services.IServiceLocator;

/**
 * Menus that the platform fills with what all bundles contribute. What it knows of such a menu and of its items it
 * keeps for ever, also when the menu was released, unless it is told one by one: the search fills six menus each time
 * that it opens. Display thread only.
 */
@SuppressWarnings("restriction") // the platform has no public way to have the items of a menu forgotten
final class FilledMenus {
  private final IMenuService service;
  private final IRendererFactory renderers;

  FilledMenus(IServiceLocator locator) {
    service = locator.getService(IMenuService.class);
    renderers = locator.getService(IRendererFactory.class);
  }

  MenuManager fill(String id) {
    MenuManager manager = new MenuManager(id, id);
    service.populateContributionManager(manager, "menu:" + id);
    return manager;
  }

  void release(MenuManager manager) {
    MMenu any = MMenuFactory.INSTANCE.createMenu();
    List<IContributionItem> items = List.of(manager.getItems());
    if (renderers.getRenderer(any, null) instanceof MenuManagerRenderer renderer) {
      Optional<MMenu> model = Optional.ofNullable(renderer.getMenuModel(manager));
      service.releaseContributions(manager);
      items.forEach(item -> forget(renderer, item));
      model.ifPresent(renderer::cleanUp);
      model.ifPresent(known -> renderer.clearModelToManager(known, manager));
    }
    manager.dispose();
  }

  private static void forget(MenuManagerRenderer renderer, IContributionItem item) {
    MMenuElement element = renderer.getMenuElement(item);
    if (element != null) {
      renderer.clearModelToContribution(element, item);
    }
    if (item instanceof MenuManager below) {
      for (IContributionItem inner : below.getItems()) {
        forget(renderer, inner);
      }
    }
  }
}
