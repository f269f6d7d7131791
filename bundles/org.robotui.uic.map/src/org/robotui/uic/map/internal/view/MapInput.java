package org.robotui.uic.map.internal.view;

import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.widgets.Event;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.scene.SceneHands;

/** Mouse and keys of a map, beside those that move it. Display thread. */
final class MapInput {
  private static final int REST_MILLIS = 350;
  /** As far as a hand moves that only clicks, pixels. */
  private static final int STILL = 4;

  private final MapCanvas map;
  private final PaintedCanvas surface;
  private final Runnable rest;
  private final SceneHands moving;
  private Optional<Point> pressed = Optional.empty();
  private boolean drawing;

  MapInput(MapCanvas map, PaintedCanvas surface) {
    this.map = map;
    this.surface = surface;
    this.moving = new SceneHands(surface, map.mover().held(this::press));
    this.rest = () -> {
      if (!surface.isDisposed()) {
        map.rest();
      }
    };
  }

  void listen() {
    surface.addListener(SWT.MouseMove, this::move);
    surface.addListener(SWT.MouseUp, this::up);
    surface.addListener(SWT.MouseExit, e -> leave());
    surface.addListener(SWT.MenuDetect, this::menu);
    surface.addListener(SWT.KeyDown, this::key);
    surface.atEnd(() -> surface.getDisplay().timerExec(-1, rest));
  }

  private boolean press(int x, int y) {
    pressed = Optional.of(new Point(x, y));
    drawing = map.tool().isPresent();
    map.tool().ifPresent(t -> {
      t.down(map.mover().viewport().worldX(x), map.mover().viewport().worldY(y));
      map.repaint();
    });
    return drawing;
  }

  private void move(Event e) {
    map.hover().at(e.x, e.y);
    if (drawing && !moving.panning()) {
      map.tool().ifPresent(t -> t.drag(worldX(e), worldY(e)));
    } else if (!moving.panning()) {
      map.tool().ifPresent(t -> t.hover(worldX(e), worldY(e)));
    }
    boolean held = moving.panning() || drawing;
    surface.getDisplay().timerExec(held ? -1 : REST_MILLIS, rest);
    surface.requestPaint();
  }

  private void up(Event e) {
    if (drawing && e.button == 1) {
      drawing = false;
      map.tool().ifPresent(t -> t.up(worldX(e), worldY(e)));
      map.repaint();
    } else if (e.button == 1 && pressed.filter(p -> Math.hypot(p.x - e.x, p.y - e.y) < STILL).isPresent()) {
      map.click(new Point(e.x, e.y), (e.stateMask & (SWT.MOD1 | SWT.SHIFT)) != 0);
    }
    pressed = Optional.empty();
  }

  private void leave() {
    surface.getDisplay().timerExec(-1, rest);
    map.hover().away();
    surface.requestPaint();
  }

  private void menu(Event e) {
    Point at = surface.toControl(e.x, e.y);
    e.doit = false;
    map.openMenu(at.x, at.y);
  }

  private void key(Event e) {
    switch (Character.toLowerCase(e.character)) {
      case 'f' -> map.toggleFollow();
      case 'g' -> map.toggleTool(MapActions.GOAL);
      case 'm' -> map.toggleTool(MapActions.MEASURE);
      case 'p' -> map.toggleTool(MapActions.POSE);
      case 'l' -> map.toggleList();
      case SWT.ESC -> endTool();
      default -> {}
    }
  }

  private void endTool() {
    drawing = false;
    map.endTool();
  }

  private double worldX(Event e) {
    return map.mover().viewport().worldX(e.x);
  }

  private double worldY(Event e) {
    return map.mover().viewport().worldY(e.y);
  }
}
