package org.robotui.testkit;

import java.util.function.LongSupplier;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Image;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;

/**
 * Hands and eyes on a control that paints itself. After each move what it asked for is painted. Display thread.
 *
 * @param canvas the control
 * @param paints counts how often it has painted
 * @param request asks it to paint
 */
public record CanvasHands(Control canvas, LongSupplier paints, Runnable request) {
  private static final long PATIENCE_NANOS = 30_000_000_000L;

  /**
   * Moves the mouse or presses a button.
   *
   * @param type of event, such as {@link SWT#MouseDown}
   * @param button which, 0 for none
   * @param x points from the left
   * @param y points from the top
   */
  public void mouse(int type, int button, int x, int y) {
    Event event = at(x, y);
    event.button = button;
    send(type, event);
  }

  /**
   * Turns the wheel.
   *
   * @param count of notches, positive away from the user
   * @param x points from the left
   * @param y points from the top
   */
  public void wheel(int count, int x, int y) {
    Event event = at(x, y);
    event.count = count;
    send(SWT.MouseVerticalWheel, event);
  }

  /**
   * Presses a key.
   *
   * @param character what it types
   */
  public void key(char character) {
    Event event = new Event();
    event.character = character;
    event.keyCode = character;
    send(SWT.KeyDown, event);
  }

  /** Runs what the display thread has to do until the canvas has painted what was asked for. */
  public void settle() {
    long before = paints.getAsLong();
    request.run();
    long deadline = System.nanoTime() + PATIENCE_NANOS;
    while (canvas.isVisible() && paints.getAsLong() == before && System.nanoTime() < deadline) {
      if (!canvas.getDisplay().readAndDispatch()) {
        Thread.onSpinWait();
      }
    }
  }

  /**
   * What is seen of a control.
   *
   * @param shown the canvas, or what it lies in
   * @return its picture, in the pixels of the screen
   */
  public static ImageData picture(Control shown) {
    Image image = new Image(shown.getDisplay(), shown.getSize().x, shown.getSize().y);
    GC gc = new GC(shown);
    gc.copyArea(image, 0, 0);
    gc.dispose();
    ImageData data = image.getImageData(shown.getMonitor().getZoom());
    image.dispose();
    return data;
  }

  private void send(int type, Event event) {
    canvas.notifyListeners(type, event);
    settle();
  }

  private static Event at(int x, int y) {
    Event event = new Event();
    event.x = x;
    event.y = y;
    return event;
  }
}
