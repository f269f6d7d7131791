package org.robotui.workbench.internal.dock;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Listener;
import org.eclipse.swt.widgets.Shell;
import org.robotui.api.layout.DropTarget;
import org.robotui.api.layout.Edge;
import org.robotui.api.layout.WindowBounds;

/**
 * One view that is dragged by its title: shows where it would lie, and says where it is dropped. Display thread only.
 */
final class TabDrag {
  private static final int BORDER = 14;
  private static final double BORDER_SHARE = 0.3;
  private static final Point OWN_SIZE = new Point(640, 480);

  private final String view;
  private final Docking docking;
  private final DockWindows windows;
  private final Display display;
  private final Listener escape = e -> cancel(e.keyCode);
  private Optional<DockTree> over = Optional.empty();
  private boolean cancelled;

  /** A place under the pointer, what would be taken of it, and how that is called. */
  private record Place(DockTree tree, DropTarget target, Rectangle part, String words) {}

  TabDrag(String view, Docking docking, DockWindows windows, Display display) {
    this.view = view;
    this.docking = docking;
    this.windows = windows;
    this.display = display;
    display.addFilter(SWT.KeyDown, escape);
  }

  String view() {
    return view;
  }

  /** The pointer is at a point of the display. */
  void to(Point at) {
    Optional<Place> place = cancelled ? Optional.empty() : place(at);
    over.filter(tree -> place.filter(p -> p.tree() == tree).isEmpty() && !tree.isDisposed())
        .ifPresent(tree -> tree.frame().hide());
    over = place.map(Place::tree);
    place.ifPresent(p -> p.tree().frame().show(p.part(), p.words()));
  }

  /** It is let go at a point of the display. */
  void drop(Point at) {
    Optional<DropTarget> target = cancelled ? Optional.empty() : place(at).map(Place::target).or(() -> outside(at));
    end();
    target.ifPresent(t -> docking.move(view, t));
  }

  private void cancel(int key) {
    if (key == SWT.ESC) {
      cancelled = true;
      end();
    }
  }

  private void end() {
    display.removeFilter(SWT.KeyDown, escape);
    over.filter(tree -> !tree.isDisposed()).ifPresent(tree -> tree.frame().hide());
    over = Optional.empty();
  }

  /** Beside all our windows a view gets a window of its own. */
  private Optional<DropTarget> outside(Point at) {
    boolean within = List.of(display.getShells()).stream().filter(Shell::isVisible)
        .anyMatch(shell -> shell.getBounds().contains(at));
    return within ? Optional.empty()
        : Optional.of(new DropTarget.OwnWindow(new WindowBounds(at.x, at.y, OWN_SIZE.x, OWN_SIZE.y)));
  }

  private Optional<Place> place(Point at) {
    return windows.trees().stream()
        .filter(tree -> tree.isVisible() && tree.getClientArea().contains(tree.toControl(at)))
        .findFirst().flatMap(tree -> place(tree, at));
  }

  private Optional<Place> place(DockTree tree, Point at) {
    int window = windows.number(tree);
    Rectangle whole = tree.getClientArea();
    Optional<Edge> border = DropSides.border(whole, tree.toControl(at), BORDER);
    if (tree.stacks().isEmpty()) {
      return Optional.of(new Place(tree, new DropTarget.Border(window, Edge.LEFT), whole, "Here"));
    }
    if (border.isPresent() && tree.stacks().size() > 1) {
      return border.map(edge -> new Place(tree, new DropTarget.Border(window, edge),
          DropSides.part(whole, edge, BORDER_SHARE), "Along the " + side(edge) + " side"));
    }
    return tree.stackAt(at).map(stack -> place(tree, stack, at));
  }

  private Place place(DockTree tree, ViewStack stack, Point at) {
    Rectangle whole = tree.place(stack);
    TitleLine line = stack.line();
    String mate = stack.ids().stream().filter(id -> !id.equals(view)).findFirst().orElse(view);
    String name = line.titleOf(stack.ids().indexOf(mate));
    Point inLine = line.toControl(at);
    if (inLine.y <= TitleLine.HEIGHT) {
      return new Place(tree, new DropTarget.Tab(mate, before(stack, line.indexBefore(inLine.x))), whole,
          "Tab with " + name);
    }
    Rectangle body =
        new Rectangle(whole.x, whole.y + TitleLine.HEIGHT, whole.width, whole.height - TitleLine.HEIGHT);
    return DropSides.side(body, tree.toControl(at)).map(edge -> new Place(tree, new DropTarget.Side(mate, edge),
        DropSides.part(whole, edge, 0.5), words(edge, name)))
        .orElseGet(() -> new Place(tree, new DropTarget.Tab(mate, Integer.MAX_VALUE), whole, "Tab with " + name));
  }

  /** Among the others: the view itself does not count, where it is one of these tabs. */
  private int before(ViewStack stack, int index) {
    int own = stack.ids().indexOf(view);
    return own >= 0 && own < index ? index - 1 : index;
  }

  private static String words(Edge edge, String name) {
    return switch (edge) {
      case LEFT -> "Left of " + name;
      case RIGHT -> "Right of " + name;
      case TOP -> "Above " + name;
      case BOTTOM -> "Below " + name;
    };
  }

  private static String side(Edge edge) {
    return switch (edge) {
      case LEFT -> "left";
      case RIGHT -> "right";
      case TOP -> "upper";
      case BOTTOM -> "lower";
    };
  }
}
