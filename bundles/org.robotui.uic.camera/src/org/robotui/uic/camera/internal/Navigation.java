package org.robotui.uic.camera.internal;

import java.util.Optional;
import java.util.function.Supplier;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Canvas;
import org.eclipse.swt.widgets.Event;
import org.robotui.entity.image.Picture;

/**
 * Zoom and pan by mouse and keys: wheel at the pointer, middle drag (or left, once zoomed), double click fits, plus, minus,
 * arrows and 0. Display thread.
 */
final class Navigation {
  private static final double STEP = 1.25;
  private static final int KEY_POINTS = 32;

  private final Canvas canvas;
  private final Supplier<Optional<Picture>> picture;
  private PictureView view = PictureView.FIT;
  private Optional<Point> pointer = Optional.empty();
  private Optional<Point> grabbed = Optional.empty();

  Navigation(Canvas canvas, Supplier<Optional<Picture>> picture) {
    this.canvas = canvas;
    this.picture = picture;
  }

  void listen() {
    canvas.addListener(SWT.MouseVerticalWheel, e -> zoom(e.count > 0 ? STEP : 1 / STEP, new Point(e.x, e.y)));
    canvas.addListener(SWT.MouseDown, this::down);
    canvas.addListener(SWT.MouseMove, this::move);
    canvas.addListener(SWT.MouseUp, e -> grabbed = Optional.empty());
    canvas.addListener(SWT.MouseExit, e -> leave());
    canvas.addListener(SWT.MouseDoubleClick, e -> fit());
    canvas.addListener(SWT.KeyDown, this::key);
    canvas.addListener(SWT.Traverse, e -> e.doit = e.detail == SWT.TRAVERSE_TAB_NEXT || e.detail == SWT.TRAVERSE_TAB_PREVIOUS);
  }

  PictureView view() {
    return view;
  }

  /** Where the pointer is, while it is over the view. */
  Optional<Point> pointer() {
    return pointer;
  }

  void fit() {
    see(PictureView.FIT);
  }

  private void see(PictureView next) {
    view = next;
    canvas.redraw();
  }

  private void zoom(double factor, Point at) {
    picture.get().ifPresent(p -> see(view.zoomed(factor, at, canvas.getClientArea(), p.width(), p.height())));
  }

  private void pan(int dx, int dy) {
    picture.get().ifPresent(p -> see(view.moved(dx, dy, canvas.getClientArea(), p.width(), p.height())));
  }

  private void down(Event event) {
    canvas.setFocus();
    if (event.button == 1 || event.button == 2) {
      grabbed = Optional.of(new Point(event.x, event.y));
    }
  }

  private void move(Event event) {
    Point here = new Point(event.x, event.y);
    grabbed.ifPresent(from -> pan(here.x - from.x, here.y - from.y));
    grabbed = grabbed.map(from -> here);
    pointer = Optional.of(here);
    canvas.redraw();
  }

  private void leave() {
    pointer = Optional.empty();
    canvas.redraw();
  }

  private void key(Event event) {
    switch (event.keyCode) {
      case '+', '=', SWT.KEYPAD_ADD -> zoom(STEP, middle());
      case '-', SWT.KEYPAD_SUBTRACT -> zoom(1 / STEP, middle());
      case '0', SWT.KEYPAD_0, SWT.HOME -> fit();
      case SWT.ARROW_LEFT -> pan(KEY_POINTS, 0);
      case SWT.ARROW_RIGHT -> pan(-KEY_POINTS, 0);
      case SWT.ARROW_UP -> pan(0, KEY_POINTS);
      case SWT.ARROW_DOWN -> pan(0, -KEY_POINTS);
      default -> { }
    }
  }

  private Point middle() {
    Rectangle area = canvas.getClientArea();
    return new Point(area.width / 2, area.height / 2);
  }
}
