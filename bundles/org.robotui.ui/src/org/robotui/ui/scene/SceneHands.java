package org.robotui.ui.scene;

import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;

/**
 * The hands on a scene: the left or middle button moves it, the wheel zooms at the pointer, a double click shows all;
 * plus, minus, 0, Home and the arrows do the same from the keyboard. Display thread.
 */
public final class SceneHands {
  /** What the hands move. */
  public interface Held {
    /**
     * What is seen now.
     *
     * @return the viewport
     */
    Viewport viewport();

    /**
     * Moves the content with the hand.
     *
     * @param dx pixels to the right
     * @param dy pixels down
     */
    void pan(double dx, double dy);

    /**
     * Zooms; what lies at the pixel stays there.
     *
     * @param x pixels from the left
     * @param y pixels from the top
     * @param factor above 1 to come closer
     */
    void zoom(double x, double y, double factor);

    /** Shows all. */
    void fit();

    /**
     * The left button goes down.
     *
     * @param x pixels from the left
     * @param y pixels from the top
     * @return whether something takes it, for example a tool, so that the scene is not moved
     */
    boolean press(int x, int y);
  }

  private static final double WHEEL_FACTOR = 1.2;
  private static final double KEY_FACTOR = 1.4;
  private static final int KEY_PAN = 60;

  private final Control surface;
  private final Held held;
  private Optional<Point> panned = Optional.empty();
  private boolean taken;

  /**
   * Begins to listen.
   *
   * @param surface what the scene is painted on
   * @param held what is moved
   */
  public SceneHands(Control surface, Held held) {
    this.surface = surface;
    this.held = held;
    surface.addListener(SWT.MouseDown, this::down);
    surface.addListener(SWT.MouseMove, this::move);
    surface.addListener(SWT.MouseUp, e -> panned = Optional.empty());
    surface.addListener(SWT.MouseDoubleClick, this::doubleClick);
    surface.addListener(SWT.MouseVerticalWheel, this::wheel);
    surface.addListener(SWT.KeyDown, this::key);
    // Arrows and Esc are the scene's; Tab leads on to the next control.
    surface.addListener(SWT.Traverse,
        e -> e.doit = e.detail == SWT.TRAVERSE_TAB_NEXT || e.detail == SWT.TRAVERSE_TAB_PREVIOUS);
  }

  /**
   * Whether the scene is being moved.
   *
   * @return true while a button is down for it
   */
  public boolean panning() {
    return panned.isPresent();
  }

  private void down(Event e) {
    surface.setFocus();
    taken = e.button == 1 && held.press(e.x, e.y);
    if (!taken && e.button <= 2) {
      panned = Optional.of(new Point(e.x, e.y));
    }
  }

  private void move(Event e) {
    Point here = new Point(e.x, e.y);
    panned.ifPresent(from -> held.pan(here.x - from.x, here.y - from.y));
    panned = panned.map(from -> here);
  }

  private void doubleClick(Event e) {
    if (e.button == 1 && !taken) {
      held.fit();
    }
  }

  private void wheel(Event e) {
    e.doit = false;
    held.zoom(e.x, e.y, Math.pow(WHEEL_FACTOR, Integer.signum(e.count)));
  }

  private void key(Event e) {
    switch (e.keyCode) {
      case SWT.ARROW_LEFT -> held.pan(KEY_PAN, 0);
      case SWT.ARROW_RIGHT -> held.pan(-KEY_PAN, 0);
      case SWT.ARROW_UP -> held.pan(0, KEY_PAN);
      case SWT.ARROW_DOWN -> held.pan(0, -KEY_PAN);
      case SWT.HOME -> held.fit();
      default -> typed(e.character);
    }
  }

  private void typed(char character) {
    switch (character) {
      case '+', '=' -> zoomMiddle(KEY_FACTOR);
      case '-' -> zoomMiddle(1 / KEY_FACTOR);
      case '0' -> held.fit();
      default -> {}
    }
  }

  private void zoomMiddle(double factor) {
    Viewport v = held.viewport();
    held.zoom(v.width() / 2.0, v.height() / 2.0, factor);
  }
}
