package org.robotui.workbench.internal.dock;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.api.host.Ruic;
import org.robotui.api.layout.Arrangement;
import org.robotui.api.layout.DropTarget;
import org.robotui.api.layout.Edge;
import org.robotui.api.layout.LayoutChange;
import org.robotui.api.layout.WindowBounds;
import org.robotui.ui.control.PopupMenu;

/**
 * The menu of a view's title: all that can be done by dragging, and what belongs to the whole layout.
 *
 * @param ruic whose view it is
 * @param docking does it
 * @param addView has the user choose a view to add
 */
record TabMenu(Ruic ruic, Docking docking, Runnable addView) {
  private static final List<Edge> EDGES = List.of(Edge.LEFT, Edge.RIGHT, Edge.TOP, Edge.BOTTOM);

  void open(ViewStack stack, DockTree tree, String view, Point at) {
    Arrangement now = docking.now();
    PopupMenu menu = new PopupMenu(stack);
    menu.push("Close", () -> docking.close(view));
    menu.push("Close Others", stack.ids().size() > 1, () -> closeOthers(stack, view));
    boolean isMaximized = tree.maximized().isPresent();
    menu.push(isMaximized ? "Restore" : "Maximize", isMaximized || tree.stacks().size() > 1,
        () -> tree.maximize(isMaximized ? Optional.empty() : Optional.of(stack)));
    menu.line();
    moves(menu.under("Move To"), stack, view);
    boolean own = !now.layout().views().contains(view);
    boolean alone = own && tree.stacks().size() == 1 && stack.ids().size() == 1;
    menu.push("Move to a Window of Its Own", !alone, () -> docking.move(view, window(stack)));
    if (own) {
      menu.push("Move Back into the Main Window", () -> docking.change(back(now, view)));
    }
    menu.push("Add One More of This Type", () -> another(view));
    menu.line();
    menu.push("Add View...", addView);
    menu.push("Undo Layout Change", docking.canUndo(), docking::undo);
    menu.push("Redo Layout Change", docking.canRedo(), docking::redo);
    menu.push("Reset Layout", !now.equals(docking.arranging().written()), docking::reset);
    menu.open(at);
  }

  private void closeOthers(ViewStack stack, String view) {
    Arrangement next = docking.now();
    for (String other : stack.ids()) {
      next = other.equals(view) ? next : next.closed(other);
    }
    docking.change(next);
  }

  private void moves(PopupMenu menu, ViewStack stack, String view) {
    Arrangement now = docking.now();
    if (stack.ids().size() > 1) {
      String mate = stack.ids().stream().filter(id -> !id.equals(view)).findFirst().orElseThrow();
      EDGES.forEach(edge -> menu.push(split(edge), () -> docking.move(view, new DropTarget.Side(mate, edge))));
      menu.line();
    }
    EDGES.forEach(edge -> menu.push(border(edge), () -> docking.move(view, new DropTarget.Border(0, edge))));
    menu.line();
    now.views().stream().filter(other -> !stack.ids().contains(other))
        .filter(other -> LayoutChange.mates(now.layout(), other).indexOf(other) <= 0)
        .forEach(other -> menu.push("Tab with " + ruic.title(other),
            () -> docking.move(view, new DropTarget.Tab(other, Integer.MAX_VALUE))));
  }

  private static DropTarget window(ViewStack stack) {
    Rectangle at = stack.getDisplay().map(stack, null, stack.getClientArea());
    return new DropTarget.OwnWindow(
        new WindowBounds(at.x, at.y, Math.max(1, at.width), Math.max(1, at.height)));
  }

  private Arrangement back(Arrangement now, String view) {
    return now.without(view).opened(view, docking.arranging().written().layout());
  }

  private void another(String view) {
    docking.arranging().views().stream().filter(v -> v.id().equals(view)).findFirst()
        .ifPresent(v -> docking.add(v.type(), Optional.of(view)));
  }

  private static String split(Edge edge) {
    return switch (edge) {
      case LEFT -> "Left of Its Tabs";
      case RIGHT -> "Right of Its Tabs";
      case TOP -> "Above Its Tabs";
      case BOTTOM -> "Below Its Tabs";
    };
  }

  private static String border(Edge edge) {
    return switch (edge) {
      case LEFT -> "Left Side of the Window";
      case RIGHT -> "Right Side of the Window";
      case TOP -> "Upper Side of the Window";
      case BOTTOM -> "Lower Side of the Window";
    };
  }
}
