package org.robotui.uic.log.internal.view;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.robotui.ui.Health;
import org.robotui.ui.Theme;
import org.robotui.ui.ViewAction;
import org.robotui.ui.control.RowList;
import org.robotui.uic.log.internal.model.LogFilter;
import org.robotui.uic.log.internal.model.OriginCount;

/** The list of nodes that said something, for showing and hiding them. Display thread. */
final class NodePane {
  private final RowList<OriginCount> list;
  private final NodeLook look;
  private final LogHands hands;
  private LogFilter filter = LogFilter.ALL;

  NodePane(Composite parent, Theme theme, LogHands hands) {
    this.hands = hands;
    look = new NodeLook(theme);
    list = new RowList<>(parent, theme, look).named("Nodes").onOpen(this::toggle)
        .menu(nodes -> menu(nodes, filter, hands));
    list.control().addListener(SWT.MouseUp, this::released);
  }

  Control control() {
    return list.control();
  }

  void show(List<OriginCount> seen, LogFilter next) {
    filter = next;
    look.filter(next);
    List<OriginCount> rows = rows(seen, next);
    if (rows.isEmpty()) {
      list.message(Health.NONE, "No nodes", "Nothing has been logged yet.");
    } else {
      list.noMessage();
    }
    list.show(rows);
  }

  /** Those seen, and those that a filter names: else nobody could take these out of it. */
  static List<OriginCount> rows(List<OriginCount> seen, LogFilter filter) {
    Map<String, Integer> counts = new TreeMap<>();
    filter.hidden().forEach(name -> counts.put(name, 0));
    filter.only().forEach(name -> counts.put(name, 0));
    seen.forEach(node -> counts.put(node.origin(), node.count()));
    return counts.entrySet().stream().map(e -> new OriginCount(e.getKey(), e.getValue())).toList();
  }

  static List<ViewAction> menu(List<OriginCount> nodes, LogFilter filter, LogHands hands) {
    if (nodes.isEmpty()) {
      return List.of();
    }
    String name = nodes.getFirst().origin();
    return List.of(
        action("only", "Only " + name, () -> hands.filter(filter.onlyOrigin(name))),
        filter.shows(name) ? action("hide", "Hide " + name, () -> hands.filter(filter.origin(name, false)))
            : action("show", "Show " + name, () -> hands.filter(filter.origin(name, true))),
        action("all", "Show all nodes", () -> hands.filter(filter.allOrigins())));
  }

  static ViewAction action(String id, String label, Runnable run) {
    return new ViewAction(id, label, "", Optional.empty(), run);
  }

  private void released(Event event) {
    if (event.button == 1 && event.x < NodeLook.MARK) {
      list.selected().forEach(this::toggle);
    }
  }

  private void toggle(OriginCount node) {
    hands.filter(filter.origin(node.origin(), !filter.shows(node.origin())));
  }
}
