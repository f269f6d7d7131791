package org.robotui.api.layout;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;

/**
 * Where the views of one RUIC lie: in its main window, and in windows of their own. A view lies in one place; one that
 * lies nowhere is closed, and does not run.
 *
 * @param layout of the main window; tabs of which there are none where no view lies there
 * @param windows those beside the main window
 * @param added views that the configuration does not have
 */
public record Arrangement(Layout layout, List<OwnWindow> windows, List<Added> added) {
  private static final int MOST_NESTED = 30;

  /**
   * A window beside the main window.
   *
   * @param layout of its views, at least one
   * @param bounds where it lies
   */
  public record OwnWindow(Layout layout, WindowBounds bounds) {}

  /**
   * A view that the configuration does not have.
   *
   * @param id within the RUIC
   * @param type id of its type
   */
  public record Added(String id, String type) {}

  /**
   * Copies the lists and checks.
   *
   * @param layout of the main window
   * @param windows those beside the main window
   * @param added views that the configuration does not have
   */
  public Arrangement {
    windows = List.copyOf(windows);
    added = List.copyOf(added);
    List<String> all = views(layout, windows).toList();
    if (Set.copyOf(all).size() != all.size()) {
      throw new IllegalArgumentException("a view lies in two places: " + all);
    }
  }

  /**
   * All views in the main window, none added.
   *
   * @param layout of the main window
   */
  public Arrangement(Layout layout) {
    this(layout, List.of(), List.of());
  }

  /**
   * The views that lie somewhere.
   *
   * @return their ids, those of the main window first
   */
  public List<String> views() {
    return views(layout, windows).toList();
  }

  /**
   * The layout of one window.
   *
   * @param window 0 for the main window, from 1 for the others
   * @return its layout
   * @throws IndexOutOfBoundsException where there is no such window
   */
  public Layout layout(int window) {
    return window == 0 ? layout : windows.get(window - 1).layout();
  }

  /**
   * Has a view lie elsewhere, or opens one that is closed.
   *
   * @param view id of the view
   * @param target where it is to lie
   * @return the arrangement; as it was where there is no such place, or more splits would lie within one another than
   * anybody can use
   */
  public Arrangement with(String view, DropTarget target) {
    Arrangement moved = moved(view, target);
    return LayoutChange.depth(moved.layout) > MOST_NESTED
        || moved.windows.stream().anyMatch(w -> LayoutChange.depth(w.layout()) > MOST_NESTED) ? this : moved;
  }

  private Arrangement moved(String view, DropTarget target) {
    Arrangement others = without(view);
    return switch (target) {
      case DropTarget.Tab tab when others.views().contains(tab.view()) -> others
          .each(l -> l.views().contains(tab.view()) ? LayoutChange.tabbed(l, view, tab) : l);
      case DropTarget.Side side when others.views().contains(side.view()) -> others
          .each(l -> l.views().contains(side.view()) ? LayoutChange.beside(l, view, side) : l);
      case DropTarget.Border border -> bordered(view, border);
      case DropTarget.OwnWindow own -> others.with(new OwnWindow(new Layout.View(view), own.bounds()));
      default -> this;
    };
  }

  /**
   * Opens a view where it lies in another arrangement: among the tabs of those that it lies with there.
   *
   * @param view id of a view that lies nowhere
   * @param usual where views usually lie
   * @return the arrangement, with the view in front of its tabs; along the lower side where its mates are closed, too
   */
  public Arrangement opened(String view, Layout usual) {
    return LayoutChange.mates(usual, view).stream().filter(views()::contains).findFirst()
        .map(mate -> with(view, new DropTarget.Tab(mate, Integer.MAX_VALUE)))
        .orElseGet(() -> with(view, new DropTarget.Border(0, Edge.BOTTOM)));
  }

  /**
   * Closes a view. One that the configuration does not have is forgotten.
   *
   * @param view id of the view
   * @return the arrangement; a window without views is gone
   */
  public Arrangement closed(String view) {
    Arrangement left = without(view);
    return new Arrangement(left.layout, left.windows, added.stream().filter(a -> !a.id().equals(view)).toList());
  }

  /**
   * Has a view lie nowhere.
   *
   * @param view id of the view
   * @return the arrangement; a window without views is gone
   */
  public Arrangement without(String view) {
    List<OwnWindow> left = windows.stream()
        .map(w -> new OwnWindow(LayoutChange.without(w.layout(), List.of(view)), w.bounds()))
        .filter(w -> !w.layout().views().isEmpty()).toList();
    return new Arrangement(LayoutChange.without(layout, List.of(view)), left, added);
  }

  /**
   * The same with a view that the configuration does not have; it lies nowhere yet.
   *
   * @param view not among {@link #added()}
   * @return the arrangement
   */
  public Arrangement adding(Added view) {
    return new Arrangement(layout, windows, Stream.concat(added.stream(), Stream.of(view)).toList());
  }

  /**
   * Has a view in front of its tabs.
   *
   * @param view id of the view
   * @return the arrangement
   */
  public Arrangement fronted(String view) {
    return each(l -> LayoutChange.fronted(l, view));
  }

  /**
   * Whether all views lie as in another arrangement, whichever tabs are in front.
   *
   * @param other the other arrangement
   * @return false also where a window lies elsewhere
   */
  public boolean liesAs(Arrangement other) {
    return each(LayoutChange::unfronted).equals(other.each(LayoutChange::unfronted));
  }

  /**
   * Gives the parts of a split other shares.
   *
   * @param window 0 for the main window, from 1 for the others
   * @param place as for {@link LayoutChange#weighted}
   * @param weights as many as it has parts, positive
   * @return the arrangement
   */
  public Arrangement weighted(int window, List<Integer> place, List<Double> weights) {
    return changed(window, l -> LayoutChange.weighted(l, place, weights));
  }

  /**
   * Has a window lie elsewhere.
   *
   * @param window from 1
   * @param bounds where
   * @return the arrangement
   */
  public Arrangement placed(int window, WindowBounds bounds) {
    List<OwnWindow> next = new ArrayList<>(windows);
    next.set(window - 1, new OwnWindow(windows.get(window - 1).layout(), bounds));
    return new Arrangement(layout, next, added);
  }

  /**
   * Keeps only some of its views.
   *
   * @param known ids
   * @return the arrangement without all others
   */
  public Arrangement only(Set<String> known) {
    Arrangement left = this;
    for (String view : views()) {
      left = known.contains(view) ? left : left.without(view);
    }
    return new Arrangement(left.layout, left.windows, added.stream().filter(a -> known.contains(a.id())).toList());
  }

  /** The window along whose side it is to lie may be the one that it leaves empty. */
  private Arrangement bordered(String view, DropTarget.Border border) {
    Optional<Layout> there = border.window() == 0 ? Optional.of(layout)
        : windows.stream().skip(Math.max(0, border.window() - 1)).findFirst().map(OwnWindow::layout);
    if (there.isEmpty() || there.get().views().equals(List.of(view))) {
      return this;
    }
    List<String> mates = there.get().views();
    return without(view)
        .each(l -> isSame(l, mates, border.window()) ? LayoutChange.bordered(l, view, border.edge()) : l);
  }

  private static boolean isSame(Layout layout, List<String> mates, int window) {
    return mates.isEmpty() ? window == 0 && layout.views().isEmpty()
        : layout.views().stream().anyMatch(mates::contains);
  }

  private Arrangement with(OwnWindow window) {
    return new Arrangement(layout, Stream.concat(windows.stream(), Stream.of(window)).toList(), added);
  }

  private Arrangement changed(int window, UnaryOperator<Layout> change) {
    if (window == 0) {
      return new Arrangement(change.apply(layout), windows, added);
    }
    List<OwnWindow> next = new ArrayList<>(windows);
    next.set(window - 1, new OwnWindow(change.apply(layout(window)), windows.get(window - 1).bounds()));
    return new Arrangement(layout, next, added);
  }

  private Arrangement each(UnaryOperator<Layout> change) {
    return new Arrangement(change.apply(layout),
        windows.stream().map(w -> new OwnWindow(change.apply(w.layout()), w.bounds())).toList(), added);
  }

  private static Stream<String> views(Layout layout, List<OwnWindow> windows) {
    return Stream.concat(layout.views().stream(), windows.stream().flatMap(w -> w.layout().views().stream()));
  }
}
