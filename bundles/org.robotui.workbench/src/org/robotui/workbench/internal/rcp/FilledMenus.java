package org.robotui.workbench.internal.rcp;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.eclipse.e4.ui.model.application.MApplication;
import org.eclipse.e4.ui.model.application.ui.menu.MMenu;
import org.eclipse.e4.ui.model.application.ui.menu.MMenuContribution;
import org.eclipse.e4.ui.model.application.ui.menu.MMenuElement;
import org.eclipse.e4.ui.model.application.ui.menu.MMenuFactory;
import org.eclipse.e4.ui.workbench.renderers.swt.MenuManagerRenderer;
import org.eclipse.e4.ui.workbench.swt.factories.IRendererFactory;
import org.eclipse.jface.action.IContributionItem;
import org.eclipse.jface.action.MenuManager;
import org.eclipse.ui.IWorkbenchWindow;
import org.eclipse.ui.menus.IMenuService;

/**
 * The menus of a window that the platform fills with what all bundles contribute. One is filled once, and anew when
 * bundles with contributions have come or gone: of each filling the platform keeps something for ever, as its items
 * listen to their commands and never end that. What it keeps beside these it forgets when it is told one by one.
 * Display thread only.
 */
@SuppressWarnings("restriction") // the platform has no public way to have the items of a menu forgotten
final class FilledMenus {
  private static final String KEY = FilledMenus.class.getName();

  private final IMenuService service;
  private final IRendererFactory renderers;
  private final MApplication application;
  private final Map<String, Filled> filled = new HashMap<>();

  /** A menu, and all contributions that there were when it was filled. */
  private record Filled(MenuManager manager, List<MMenuContribution> contributions) {}

  private FilledMenus(IWorkbenchWindow window) {
    service = window.getService(IMenuService.class);
    renderers = window.getService(IRendererFactory.class);
    application = window.getService(MApplication.class);
  }

  /** Those of a window, which keeps them. */
  static FilledMenus of(IWorkbenchWindow window) {
    if (window.getShell().getData(KEY) instanceof FilledMenus known) {
      return known;
    }
    FilledMenus menus = new FilledMenus(window);
    window.getShell().setData(KEY, menus);
    return menus;
  }

  MenuManager menu(String id) {
    List<MMenuContribution> now = List.copyOf(application.getMenuContributions());
    Optional<Filled> known = Optional.ofNullable(filled.get(id));
    if (known.isPresent() && known.get().contributions().equals(now)) {
      return known.get().manager();
    }
    known.ifPresent(old -> release(old.manager()));
    MenuManager manager = new MenuManager(id, id);
    service.populateContributionManager(manager, "menu:" + id);
    filled.put(id, new Filled(manager, now));
    return manager;
  }

  private void release(MenuManager manager) {
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
