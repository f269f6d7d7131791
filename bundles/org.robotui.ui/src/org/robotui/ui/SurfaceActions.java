package org.robotui.ui;

import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Predicate;

/**
 * Makes the actions of a view, which stay the same, for its surface, which is made anew each time the view is shown.
 * Without a surface they do nothing. Display thread.
 *
 * @param <S> the surface
 */
public final class SurfaceActions<S> {
  private Optional<S> surface = Optional.empty();

  /**
   * The surface is there.
   *
   * @param shown on which the actions work from now on
   */
  public void connect(S shown) {
    surface = Optional.of(shown);
  }

  /**
   * The surface has gone.
   *
   * @param gone the surface; another one stays
   */
  public void disconnect(S gone) {
    surface = surface.filter(s -> s != gone);
  }

  /**
   * An action.
   *
   * @param id unique within the view
   * @param label what it does
   * @param icon its drawing
   * @param run does it
   * @return the action
   */
  public ViewAction action(String id, String label, Icon icon, Consumer<S> run) {
    return new ViewAction(id, label, icon.id(), Optional.empty(), () -> surface.ifPresent(run));
  }

  /**
   * An action that is switched.
   *
   * @param id unique within the view
   * @param label what it does
   * @param icon its drawing
   * @param on whether it is on
   * @param run switches it
   * @return the action
   */
  public ViewAction switched(String id, String label, Icon icon, Predicate<S> on, Consumer<S> run) {
    return new ViewAction(id, label, icon.id(), Optional.of(() -> surface.filter(on).isPresent()),
        () -> surface.ifPresent(run));
  }
}
