package org.robotui.ui;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;

/**
 * A view in a window that is made of two parts: this one lives as long as the view, and prepares in {@link #tick}. Its
 * surface is made anew each time the view is shown, and shows what was prepared.
 *
 * @param <S> what is seen of the view
 */
public abstract class SurfaceUic<S extends ViewSurface> implements SwtUic {
  private final SurfaceActions<S> actions = new SurfaceActions<>(this::shown);
  private volatile Optional<S> surface = Optional.empty();

  /**
   * Makes a surface; {@link #refresh(ViewSurface)} follows. Display thread.
   *
   * @param parent the part's composite, with a fill layout
   * @param context what the window gives
   * @return the surface
   */
  protected abstract S open(Composite parent, UiContext context);

  /**
   * Has the surface show what the last ticks prepared. Display thread.
   *
   * @param shown the newest surface, which may be disposed
   */
  protected abstract void refresh(S shown);

  /**
   * The newest surface. Any thread may ask, but most of what a surface can do is for the display thread.
   *
   * @return none until the view is shown; may be disposed
   */
  protected final Optional<S> surface() {
    return surface;
  }

  /**
   * Does something at the surface, and nothing while there is none. Display thread.
   *
   * @param act for example shows one of several things
   */
  protected final void atSurface(Consumer<S> act) {
    shown().ifPresent(act);
  }

  private Optional<S> shown() {
    return surface.filter(s -> !s.control().isDisposed());
  }

  /**
   * What the user can do. The constructor of a view adds to it, in the order shown.
   *
   * @return the actions
   */
  protected final SurfaceActions<S> offers() {
    return actions;
  }

  @Override
  public final Control createControl(Composite parent, UiContext context) {
    S made = open(parent, context);
    surface = Optional.of(made);
    refresh(made);
    return made.control();
  }

  @Override
  public final void refresh() {
    surface.ifPresent(this::refresh);
  }

  @Override
  public final List<ViewAction> actions() {
    return actions.all();
  }

  /** Does nothing: what belongs to the display goes with the control. For views that hold no more than memory. */
  @Override
  public void close() {
    // as it says
  }
}
