package org.robotui.workbench.internal.rcp;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.eclipse.ui.IWorkbenchWindow;
import org.robotui.api.host.Ruic;
import org.robotui.workbench.internal.WorkbenchSession;
import org.robotui.workbench.internal.model.SearchEntry;
import org.robotui.workbench.internal.pane.Menus;
import org.robotui.workbench.internal.dock.RuicSurface;
import org.robotui.workbench.internal.dock.ViewEntry;

/**
 * What the search of a window finds: robots, views and what they can do, and all that is in the menus. Display thread
 * only.
 */
final class SearchEntries {
  private final WorkbenchSession session;
  private final IWorkbenchWindow window;

  SearchEntries(WorkbenchSession session, IWorkbenchWindow window) {
    this.session = session;
    this.window = window;
  }

  /**
   * All shortcuts: of the view that has the focus, of the window, then of the other views. Choosing one of a view shows
   * that view.
   */
  List<SearchEntry> shortcuts() {
    Optional<RuicSurface> surface = surface();
    Optional<String> focused = surface.flatMap(RuicSurface::focused).map(ViewEntry::id);
    List<SearchEntry> entries = new ArrayList<>();
    surface.ifPresent(shown -> shown.views().stream().filter(view -> focused.filter(view.id()::equals).isPresent())
        .forEach(view -> entries.addAll(keys(shown, view))));
    all().stream().filter(entry -> !entry.keys().isEmpty()).forEach(entries::add);
    surface.ifPresent(shown -> shown.views().stream().filter(view -> focused.filter(view.id()::equals).isEmpty())
        .forEach(view -> entries.addAll(keys(shown, view))));
    return entries;
  }

  private static List<SearchEntry> keys(RuicSurface shown, ViewEntry view) {
    return view.keys().stream()
        .map(key -> new SearchEntry(view.title(), key.does(), key.keys(), () -> shown.reveal(view.id()))).toList();
  }

  private Optional<RuicSurface> surface() {
    return RobotPart.in(window).flatMap(part -> part.area().surface());
  }

  List<SearchEntry> all() {
    List<SearchEntry> entries = new ArrayList<>();
    Optional<RuicSurface> surface = surface();
    // The views themselves are in the menu View.
    surface.ifPresent(shown -> shown.views().forEach(
        view -> view.actions().forEach(action -> entries.add(new SearchEntry(view.title(), action.label(), "", () -> {
          shown.reveal(view.id());
          action.run().run();
        })))));
    WindowActions actions = new WindowActions(session, window);
    session.host().ruics().stream().map(Ruic::name)
        .forEach(name -> entries.add(new SearchEntry("Robot", "Show " + name, "", () -> actions.select(name))));
    Menus.ALL.forEach(menu -> entries.addAll(new PopupMenu(window, menu.id()).entries(menu.label())));
    entries.add(new SearchEntry("Platform", "Search everything of the platform\u2026", "",
        () -> new WorkbenchCommands(window).run("org.eclipse.ui.window.quickAccess")));
    return entries;
  }
}
