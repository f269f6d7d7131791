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
  private final Supplier<Optional<S>> shown;
  private final List<ViewAction> all = new ArrayList<>();

  /**
   * Without actions.
   *
   * @param shown the surface that can be used now; none while there is none, or it is disposed
   */
  SurfaceActions(Supplier<Optional<S>> shown) {
    this.shown = shown;
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
    return add(id, label, icon, () -> shown.get().ifPresent(run));
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
    return add(id, label, icon, () -> shown.get().filter(on).isPresent(), () -> shown.get().ifPresent(run));
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
}
