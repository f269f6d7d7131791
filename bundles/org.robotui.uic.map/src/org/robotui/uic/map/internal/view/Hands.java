package org.robotui.uic.map.internal.view;

import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.widgets.Event;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.scene.Viewport;

/** Mouse and keys of a map. Display thread. */
final class Hands {
  private static final double WHEEL_FACTOR = 1.2;
  private static final double KEY_FACTOR = 1.4;
  private static final int KEY_PAN = 60;
  private static final int REST_MILLIS = 350;

  private final MapCanvas map;
  private final PaintedCanvas surface;
  private final Runnable rest;
  private Optional<Point> panned = Optional.empty();
  private boolean drawing;

  Hands(MapCanvas map, PaintedCanvas surface) {
    this.map = map;
    this.surface = surface;
    this.rest = () -> {
      if (!surface.isDisposed()) {
        map.rest();
      }
    };
  }

  void listen() {
    surface.addListener(SWT.MouseDown, this::down);
    surface.addListener(SWT.MouseMove, this::move);
    surface.addListener(SWT.MouseUp, this::up);
    surface.addListener(SWT.MouseExit, e -> leave());
    surface.addListener(SWT.MouseDoubleClick, this::doubleClick);
    surface.addListener(SWT.MouseVerticalWheel, this::wheel);
    surface.addListener(SWT.MenuDetect, this::menu);
    surface.addListener(SWT.KeyDown, this::key);
    // Arrows and Esc are the map's; Tab leads on to the next control.
    surface.addListener(SWT.Traverse,
        e -> e.doit = e.detail == SWT.TRAVERSE_TAB_NEXT || e.detail == SWT.TRAVERSE_TAB_PREVIOUS);
    surface.atEnd(() -> surface.getDisplay().timerExec(-1, rest));
  }

  private void down(Event e) {
    surface.setFocus();
    if (e.button == 2 || e.button == 1 && map.tool().isEmpty()) {
      panned = Optional.of(new Point(e.x, e.y));
    } else if (e.button == 1) {
      drawing = true;
      map.tool().ifPresent(t -> t.down(worldX(e), worldY(e)));
      map.refresh();
    }
  }

  private void move(Event e) {
    map.hover().at(e.x, e.y);
    if (panned.isPresent()) {
      Point from = panned.get();
      panned = Optional.of(new Point(e.x, e.y));
      map.pan(e.x - from.x, e.y - from.y);
    } else if (drawing) {
      map.tool().ifPresent(t -> t.drag(worldX(e), worldY(e)));
    }
    boolean held = panned.isPresent() || drawing;
    surface.getDisplay().timerExec(held ? -1 : REST_MILLIS, rest);
    surface.requestPaint();
  }

  private void up(Event e) {
    panned = Optional.empty();
    if (drawing && e.button == 1) {
      drawing = false;
      map.tool().ifPresent(t -> t.up(worldX(e), worldY(e)));
      map.refresh();
    }
  }

  private void leave() {
    surface.getDisplay().timerExec(-1, rest);
    map.hover().away();
    surface.requestPaint();
  }

  private void doubleClick(Event e) {
    if (e.button == 1 && map.tool().isEmpty()) {
      map.fit();
    }
  }

  private void wheel(Event e) {
    e.doit = false;
    map.zoom(e.x, e.y, Math.pow(WHEEL_FACTOR, Integer.signum(e.count)));
  }

  private void menu(Event e) {
    Point at = surface.toControl(e.x, e.y);
    e.doit = false;
    map.openMenu(at.x, at.y);
  }

  private void key(Event e) {
    if (!moved(e.keyCode)) {
      switch (Character.toLowerCase(e.character)) {
        case '+', '=' -> zoomMiddle(KEY_FACTOR);
        case '-' -> zoomMiddle(1 / KEY_FACTOR);
        case '0' -> map.fit();
        case 'f' -> map.toggleFollow();
        case 'g' -> map.toggleTool(MapActions.GOAL);
        case 'm' -> map.toggleTool(MapActions.MEASURE);
        case 'p' -> map.toggleTool(MapActions.POSE);
        case 'l' -> map.openLayers();
        case SWT.ESC -> endTool();
        default -> { }
      }
    }
  }

  private boolean moved(int keyCode) {
    switch (keyCode) {
      case SWT.ARROW_LEFT -> map.pan(KEY_PAN, 0);
      case SWT.ARROW_RIGHT -> map.pan(-KEY_PAN, 0);
      case SWT.ARROW_UP -> map.pan(0, KEY_PAN);
      case SWT.ARROW_DOWN -> map.pan(0, -KEY_PAN);
      case SWT.HOME -> map.fit();
      default -> {
        return false;
      }
    }
    return true;
  }

  private void endTool() {
    drawing = false;
    map.endTool();
  }

  private void zoomMiddle(double factor) {
    Viewport v = map.viewport();
    map.zoom(v.width() / 2.0, v.height() / 2.0, factor);
  }

  private double worldX(Event e) {
    return map.viewport().worldX(e.x);
  }

  private double worldY(Event e) {
    return map.viewport().worldY(e.y);
  }
}
