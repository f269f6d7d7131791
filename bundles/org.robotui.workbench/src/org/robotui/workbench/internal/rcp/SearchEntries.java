package org.robotui.workbench.internal.rcp;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.eclipse.jface.preference.IPreferenceNode;
import org.eclipse.jface.preference.PreferenceManager;
import org.eclipse.ui.IWorkbenchWindow;
import org.eclipse.ui.dialogs.PreferencesUtil;
import org.robotui.api.host.Ruic;
import org.robotui.api.port.PortKind;
import org.robotui.api.show.Subject;
import org.robotui.workbench.internal.WorkbenchSession;
import org.robotui.workbench.internal.keys.KeyWords;
import org.robotui.workbench.internal.model.SearchEntry;
import org.robotui.workbench.internal.pane.Menus;
import org.robotui.workbench.internal.dock.RuicSurface;
import org.robotui.workbench.internal.dock.ViewEntry;

/**
 * What the search of a window finds: robots, views and what they can do, views to add, all commands, preferences, what
 * the robot sends, and what views list. Display thread only.
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
    commands().stream().filter(entry -> !entry.keys().isEmpty()).forEach(entries::add);
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

  /** All that can be found: commands and views first, then what may be many. */
  List<SearchEntry> all() {
    List<SearchEntry> entries = commands();
    WindowActions actions = new WindowActions(session, window);
    actions.layout().ifPresent(layout -> layout.choices().stream().filter(LayoutActions::isOfUse)
        .forEach(choice -> entries.add(new SearchEntry("View", "Add view: " + choice.label(), "", choice.run()))));
    entries.addAll(pages());
    session.model(window).selected().ifPresent(ruic -> entries.addAll(ports(ruic, actions)));
    surface().ifPresent(shown -> shown.items()
        .forEach(item -> entries.add(new SearchEntry(item.kind(), item.name(), item.detail(), item.show()))));
    entries.add(new SearchEntry("Platform", "Search everything of the platform\u2026", "",
        () -> new WorkbenchCommands(window).run("org.eclipse.ui.window.quickAccess")));
    return entries;
  }

  /** What views, robots and menus can do, and commands that are in no menu. */
  private List<SearchEntry> commands() {
    List<SearchEntry> entries = new ArrayList<>();
    // The views themselves are in the menu View.
    surface().ifPresent(shown -> shown.views().forEach(
        view -> view.actions().forEach(action -> entries.add(new SearchEntry(view.title(), action.label(), "", () -> {
          shown.reveal(view.id());
          action.run().run();
        })))));
    WindowActions actions = new WindowActions(session, window);
    session.host().ruics().stream().map(Ruic::name)
        .forEach(name -> entries.add(new SearchEntry("Robot", "Show " + name, "", () -> actions.select(name))));
    Menus.ALL.forEach(menu -> entries.addAll(new PopupMenu(window, menu.id()).entries(menu.label())));
    Set<String> listed = entries.stream().map(SearchEntries::plain).collect(Collectors.toSet());
    new CommandCatalog(window).all().forEach((keyed, command) -> {
      SearchEntry entry = new SearchEntry(keyed.group(), keyed.name(), KeyWords.text(session.keys().now().keys(keyed)),
          () -> new WorkbenchCommands(window).run(command));
      boolean own = !command.getId().startsWith("org.eclipse.");
      if (own && command.getParameterMap().isEmpty() && !listed.contains(plain(entry))) {
        entries.add(entry);
      }
    });
    return entries;
  }

  /** A label without what tells that something opens. */
  private static String plain(SearchEntry entry) {
    return entry.label().replaceAll("(\\.\\.\\.|\\u2026)$", "");
  }

  private List<SearchEntry> pages() {
    return window.getWorkbench().getPreferenceManager().getElements(PreferenceManager.PRE_ORDER).stream()
        .map(IPreferenceNode.class::cast)
        .map(page -> new SearchEntry("Preferences", page.getLabelText(), "", () -> PreferencesUtil
            .createPreferenceDialogOn(window.getShell(), page.getId(), null, null).open()))
        .toList();
  }

  /** What the robots of the window send; choosing one asks what is to be done with it. */
  private static List<SearchEntry> ports(Ruic ruic, WindowActions actions) {
    return ruic.snapshot().ports().stream().filter(port -> port.kind() == PortKind.STREAM)
        .map(port -> new SearchEntry("Topic", port.port().port(), port.typeName(),
            () -> actions.choose(ruic, Subject.Stream.of(port.port()))))
        .toList();
  }
}
