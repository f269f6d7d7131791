package org.robotui.workbench.internal.dock;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.widgets.Composite;
import org.robotui.api.host.Ruic;
import org.robotui.api.layout.Arrangement;
import org.robotui.api.layout.Arrangement.OwnWindow;
import org.robotui.api.layout.WindowBounds;
import org.robotui.ui.Health;
import org.robotui.ui.Theme;
import org.robotui.workbench.internal.pane.MessagePane;

/**
 * The windows of one RUIC and the places of its views in them. A place outlives the stack that it lies in, so that a
 * view that is moved goes on as it was. Display thread only.
 */
final class DockWindows implements DockTree.Builder, ViewStack.Gestures, ViewStack.Holders, ViewWindow.Listener {
  private final Composite surface;
  private final Theme theme;
  private final Ruic ruic;
  private final Docking docking;
  private final Runnable addView;
  private final DockTree main;
  private final Composite lot;
  private final List<ViewWindow> own = new ArrayList<>();
  private final Map<String, ViewHolder> holders = new HashMap<>();
  private Optional<TabDrag> drag = Optional.empty();
  private Optional<Arrangement> shown = Optional.empty();

  DockWindows(Composite surface, Theme theme, Ruic ruic, Docking docking, Runnable addView) {
    this.surface = surface;
    this.theme = theme;
    this.ruic = ruic;
    this.docking = docking;
    this.addView = addView;
    main = new DockTree(surface, theme, this);
    // Views wait here while the stacks around them are made anew.
    lot = new Aside(main);
    surface.addListener(SWT.Dispose, e -> dispose());
  }

  private void dispose() {
    List.copyOf(own).forEach(ViewWindow::dispose);
    own.clear();
  }

  /** Lays the views out. True where that changed something. */
  boolean show(Arrangement now) {
    boolean changes = !Optional.of(now).equals(shown);
    if (changes) {
      shown = Optional.of(now);
      layOut(now);
    }
    return changes;
  }

  private void layOut(Arrangement now) {
    surface.setRedraw(false);
    List<ViewWindow> wanted = windows(now);
    List<DockTree> trees = Stream.concat(Stream.of(main), wanted.stream().map(ViewWindow::tree)).toList();
    for (int i = 0; i < trees.size(); i++) {
      if (trees.get(i).wantsNewStacks(now.layout(i))) {
        park(trees.get(i));
      }
    }
    own.stream().filter(window -> !wanted.contains(window)).forEach(window -> {
      park(window.tree());
      window.dispose();
    });
    own.clear();
    own.addAll(wanted);
    for (int i = 0; i < trees.size(); i++) {
      trees.get(i).show(now.layout(i));
      trees.get(i).lock(docking.isLocked());
    }
    forget(new HashSet<>(now.views()));
    wanted.forEach(window -> window.show(title(window.tree())));
    surface.setRedraw(true);
  }

  /** Each window that is there and has a view that is to lie in it stays; others come. */
  private List<ViewWindow> windows(Arrangement now) {
    List<ViewWindow> free = new ArrayList<>(own);
    List<ViewWindow> wanted = new ArrayList<>();
    for (OwnWindow window : now.windows()) {
      List<String> views = window.layout().views();
      Optional<ViewWindow> there = free.stream()
          .filter(w -> w.tree().stacks().stream().flatMap(s -> s.ids().stream()).anyMatch(views::contains)).findFirst();
      there.ifPresent(free::remove);
      there.ifPresent(w -> w.place(window.bounds()));
      wanted.add(there.orElseGet(() -> new ViewWindow(main.getShell(), theme, window.bounds(), this, this)));
    }
    return wanted;
  }

  private void park(DockTree tree) {
    tree.stacks().stream().flatMap(ViewStack::holders).filter(holder -> !holder.isDisposed())
        .forEach(holder -> holder.into(lot, h -> {}));
  }

  private void forget(Set<String> views) {
    holders.entrySet().removeIf(entry -> {
      boolean closed = !views.contains(entry.getKey());
      if (closed) {
        entry.getValue().dispose();
      }
      return closed;
    });
  }

  private String title(DockTree tree) {
    return tree.stacks().stream().map(stack -> ruic.title(stack.seenId())).collect(Collectors.joining(", ")) + " - "
        + ruic.name();
  }

  Stream<ViewStack> stacks() {
    return trees().stream().flatMap(tree -> tree.stacks().stream());
  }

  /** Has views stay where they lie. */
  void lock(boolean now) {
    docking.lock(now);
    trees().forEach(tree -> tree.lock(now));
  }

  /** The windows of their own first: they lie in front of the main one. */
  List<DockTree> trees() {
    return Stream.concat(own.stream().map(ViewWindow::tree), Stream.of(main)).toList();
  }

  /** Which window of the arrangement a tree is: 0 for the main one, from 1 for the others. */
  int number(DockTree tree) {
    return tree == main ? 0 : trees().indexOf(tree) + 1;
  }

  void reveal(String view) {
    trees().forEach(tree -> tree.stacks().forEach(stack -> {
      if (stack.reveal(view)) {
        tree.maximized().filter(m -> m != stack).ifPresent(m -> tree.maximize(Optional.empty()));
        own.stream().filter(w -> w.tree() == tree).forEach(w -> w.shell().setActive());
      }
    }));
  }

  /** Gives a view the keys again that it had, where it still is in front of its tabs. */
  void focus(String view) {
    stacks().filter(stack -> stack.seenId().equals(view)).forEach(ViewStack::setFocus);
  }

  private Optional<DockTree> treeOf(ViewStack stack) {
    return trees().stream().filter(tree -> tree.stacks().contains(stack)).findFirst();
  }

  @Override
  public ViewStack stack(DockTree parent, Composite within, List<String> views, int front) {
    return new ViewStack(within, theme, ruic, views, front, this, this);
  }

  @Override
  public ViewHolder into(String id, Composite body, ViewHolder.Title title) {
    ViewHolder holder = holders.computeIfAbsent(id, view -> new ViewHolder(body, theme, ruic, view));
    holder.into(body, title);
    return holder;
  }

  @Override
  public void empty(Composite within) {
    new MessagePane(within, theme, Health.NONE, "No view is open here",
        "Add views of " + ruic.name() + ", or have the layout of the configuration again.",
        List.of(new MessagePane.Choice("Add view\u2026", addView),
            new MessagePane.Choice("Reset layout", docking::reset)));
  }

  @Override
  public void divided(DockTree tree, List<Integer> place, List<Double> weights) {
    docking.change(docking.now().weighted(number(tree), place, weights));
  }

  @Override
  public void fronted(String view) {
    docking.quietly(docking.now().fronted(view));
  }

  @Override
  public void menu(ViewStack stack, String view, Point at) {
    treeOf(stack).filter(tree -> !docking.isLocked())
        .ifPresent(tree -> new TabMenu(ruic, docking, addView).open(stack, tree, view, at));
  }

  @Override
  public void maximize(ViewStack stack) {
    treeOf(stack)
        .ifPresent(tree -> tree.maximize(tree.maximized().isPresent() ? Optional.empty() : Optional.of(stack)));
  }

  @Override
  public void close(String view) {
    docking.close(view);
  }

  @Override
  public void drag(String view, Point at) {
    if (!docking.isLocked()) {
      if (drag.filter(d -> d.view().equals(view)).isEmpty()) {
        drag = Optional.of(new TabDrag(view, docking, this, surface.getDisplay()));
      }
      drag.get().to(at);
    }
  }

  @Override
  public void drop(Point at) {
    Optional<TabDrag> dropped = drag;
    drag = Optional.empty();
    dropped.ifPresent(d -> d.drop(at));
  }

  @Override
  public void moved(ViewWindow window, WindowBounds bounds) {
    int index = own.indexOf(window);
    if (index >= 0 && !docking.now().windows().get(index).bounds().equals(bounds)) {
      docking.quietly(docking.now().placed(index + 1, bounds));
    }
  }

  @Override
  public boolean closed(ViewWindow window) {
    Arrangement next = docking.now();
    for (String view : window.tree().stacks().stream().flatMap(s -> s.ids().stream()).toList()) {
      next = next.closed(view);
    }
    docking.change(next);
    return !docking.isLocked();
  }
}
