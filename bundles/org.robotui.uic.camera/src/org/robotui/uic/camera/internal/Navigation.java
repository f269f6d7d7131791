package org.robotui.uic.camera.internal;

import java.util.Optional;
import java.util.function.Supplier;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Canvas;
import org.eclipse.swt.widgets.Event;

/**
 * Zoom and pan by mouse and keys: wheel at the pointer, drag with the middle or left button, double click back, plus,
 * minus and arrows. Display thread.
 */
final class Navigation {
  private static final double STEP = 1.25;
  private static final int KEY_POINTS = 32;

  private final Canvas canvas;
  private final Supplier<Optional<Stage>> stage;
  private PictureView view;
  private Optional<Point> pointer = Optional.empty();
  private Optional<Point> grabbed = Optional.empty();

  Navigation(Canvas canvas, ZoomMode mode, Supplier<Optional<Stage>> stage) {
    this.canvas = canvas;
    this.view = new PictureView(mode);
    this.stage = stage;
  }

  void listen() {
    canvas.addListener(SWT.MouseMove, this::move);
    canvas.addListener(SWT.MouseUp, e -> grabbed = Optional.empty());
    canvas.addListener(SWT.MouseExit, e -> leave());
    canvas.addListener(SWT.KeyDown, this::key);
    canvas.addListener(SWT.Traverse,
        e -> e.doit = e.detail == SWT.TRAVERSE_TAB_NEXT || e.detail == SWT.TRAVERSE_TAB_PREVIOUS);
  }

  PictureView view() {
    return view;
  }

  /** Where the pointer is, while it is over the view. */
  Optional<Point> pointer() {
    return pointer;
  }

  /** As a mode says, without zoom. */
  void see(ZoomMode mode) {
    see(new PictureView(mode));
  }

  /** Takes another mode, where it is another. */
  void follow(ZoomMode mode) {
    if (view.mode() != mode) {
      see(mode);
    }
  }

  void wheel(Event event) {
    zoom(event.count > 0 ? STEP : 1 / STEP, new Point(event.x, event.y));
  }

  void grab(Event event) {
    if (event.button == 1 || event.button == 2) {
      grabbed = Optional.of(new Point(event.x, event.y));
    }
  }

  private void see(PictureView next) {
    view = next;
    canvas.redraw();
  }

  private void zoom(double factor, Point at) {
    stage.get().ifPresent(s -> see(view.zoomed(factor, at, s)));
  }

  private void pan(int dx, int dy) {
    stage.get().ifPresent(s -> see(view.moved(dx, dy, s)));
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
      case SWT.ARROW_LEFT -> pan(KEY_POINTS, 0);
      case SWT.ARROW_RIGHT -> pan(-KEY_POINTS, 0);
      case SWT.ARROW_UP -> pan(0, KEY_POINTS);
      case SWT.ARROW_DOWN -> pan(0, -KEY_POINTS);
      default -> {}
    }
  }

  private Point middle() {
    Rectangle area = canvas.getClientArea();
    return new Point(area.width / 2, area.height / 2);
  }
}
