package org.robotui.ui;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.function.Supplier;

/**
 * The actions of a view, which stay the same while its surface is made anew each time the view is shown. Where there is
 * no surface, those that need one do nothing. Display thread.
 *
 * @param <S> the surface
 */
public final class SurfaceActions<S extends ViewSurface> {
  private final Supplier<Optional<S>> newest;
  private final List<ViewAction> all = new ArrayList<>();

  /**
   * Without actions.
   *
   * @param newest the newest surface, which may be disposed
   */
  SurfaceActions(Supplier<Optional<S>> newest) {
    this.newest = newest;
  }

  /**
   * Adds an action that needs no surface.
   *
   * @param id unique within the view
   * @param label what it does
   * @param icon its drawing
   * @param run does it
   * @return these
   */
  public SurfaceActions<S> add(String id, String label, Icon icon, Runnable run) {
    return add(new ViewAction(id, label, icon.id(), Optional.empty(), run));
  }

  /**
   * Adds an action that is switched and needs no surface.
   *
   * @param id unique within the view
   * @param label what it does
   * @param icon its drawing
   * @param on whether it is on
   * @param run switches it
   * @return these
   */
  public SurfaceActions<S> add(String id, String label, Icon icon, BooleanSupplier on, Runnable run) {
    return add(new ViewAction(id, label, icon.id(), Optional.of(on), run));
  }

  /**
   * Adds an action of the surface.
   *
   * @param id unique within the view
   * @param label what it does
   * @param icon its drawing
   * @param run does it
   * @return these
   */
  public SurfaceActions<S> action(String id, String label, Icon icon, Consumer<S> run) {
    return add(id, label, icon, () -> shown().ifPresent(run));
  }

  /**
   * Adds an action that is switched at the surface.
   *
   * @param id unique within the view
   * @param label what it does
   * @param icon its drawing
   * @param on whether it is on
   * @param run switches it
   * @return these
   */
  public SurfaceActions<S> switched(String id, String label, Icon icon, Predicate<S> on, Consumer<S> run) {
    return add(id, label, icon, () -> shown().filter(on).isPresent(), () -> shown().ifPresent(run));
  }

  /**
   * Adds an action.
   *
   * @param action any
   * @return these
   */
  public SurfaceActions<S> add(ViewAction action) {
    all.add(action);
    return this;
  }

  List<ViewAction> all() {
    return List.copyOf(all);
  }

  private Optional<S> shown() {
    return newest.get().filter(s -> !s.control().isDisposed());
  }
}
