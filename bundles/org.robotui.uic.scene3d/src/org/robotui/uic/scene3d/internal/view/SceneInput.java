package org.robotui.uic.scene3d.internal.view;

import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Event;
import org.robotui.geometry.Vector3;
import org.robotui.gl.render.Pick;
import org.robotui.ui.PaintedCanvas;
import org.robotui.uic.scene3d.internal.SceneParts;
import org.robotui.uic.scene3d.internal.camera.CameraKind;
import org.robotui.uic.scene3d.internal.camera.CameraPose;
import org.robotui.uic.scene3d.internal.camera.Lens;
import org.robotui.uic.scene3d.internal.camera.Moves;
import org.robotui.uic.scene3d.internal.model.DragState;
import org.robotui.uic.scene3d.internal.model.Picks;

/** Mouse and keys of a scene, as RViz has them. Display thread. */
final class SceneInput {
  private static final double WHEEL_FACTOR = 0.85;
  private static final double DRAG_ZOOM = 0.008;
  private static final int STILL = 4;
  private static final int REST_MILLIS = 150;
  private static final double KEY_TURN = 20;

  private final SceneSurface scene;
  private final SceneParts parts;
  private final PaintedCanvas canvas;
  private final Display display;
  private final Runnable rest;
  private final WaypointKeys waypoints;
  private final HandleKeys handles;
  private Optional<Press> press = Optional.empty();
  private Optional<DragState> grip = Optional.empty();
  private Point pointer = new Point(0, 0);
  private boolean hovering;

  /**
   * A button that is held: where it went down, where it was last, whether it is certain by now that it moves the
   * camera.
   */
  private record Press(int button, boolean shift, Point from, Point last, boolean moved, boolean turning) {
    Press at(int x, int y) {
      boolean far = moved || Math.abs(x - from.x) + Math.abs(y - from.y) > STILL;
      return new Press(button, shift, from, new Point(x, y), far, turning);
    }

    Press turns() {
      return new Press(button, shift, from, last, moved, true);
    }
  }

  SceneInput(SceneSurface scene, SceneParts parts) {
    this.scene = scene;
    this.parts = parts;
    canvas = scene.surface().control();
    display = canvas.getDisplay();
    waypoints = new WaypointKeys(scene, parts);
    handles = new HandleKeys(parts.model()::soon);
    rest = this::rested;
  }

  void listen() {
    canvas.addListener(SWT.MouseDown, this::down);
    canvas.addListener(SWT.MouseMove, this::move);
    canvas.addListener(SWT.MouseUp, this::up);
    canvas.addListener(SWT.MouseExit, e -> leave());
    canvas.addListener(SWT.MouseDoubleClick, e -> doubled());
    canvas.addListener(SWT.MouseVerticalWheel, this::wheel);
    canvas.addListener(SWT.MenuDetect, this::menu);
    canvas.addListener(SWT.KeyDown, this::key);
    canvas.addListener(SWT.FocusOut, e -> letGo());
    canvas.addListener(SWT.Traverse,
        e -> e.doit = e.detail == SWT.TRAVERSE_TAB_NEXT || e.detail == SWT.TRAVERSE_TAB_PREVIOUS);
    canvas.atEnd(() -> display.timerExec(-1, rest));
  }

  private void down(Event e) {
    canvas.setFocus();
    display.timerExec(-1, rest);
    boolean shift = (e.stateMask & SWT.SHIFT) != 0;
    press = Optional.of(new Press(e.button, shift, new Point(e.x, e.y), new Point(e.x, e.y), false, true));
    boolean handles = scene.tools().kind().isEmpty() && !shift || scene.tools().using(ToolKind.WAYPOINTS);
    if (e.button == 1 && handles && parts.model().stage().handled()) {
      press = press.map(p -> new Press(p.button(), shift, p.from(), p.last(), false, false));
      pick(e.x, e.y, hit -> gripped(hit, e.x, e.y));
    } else if (e.button == 1 && scene.tools().points()) {
      scene.tools().press(scene.lens(), e.x, e.y);
    } else if (e.button == 1 && scene.tools().using(ToolKind.MEASURE) && !shift) {
      press = press.map(p -> new Press(p.button(), false, p.from(), p.last(), false, false));
    }
  }

  /**
   * The answer to what was pressed: a handle is gripped, everything else turns the camera or is a place for a waypoint.
   */
  private void gripped(Optional<Pick> hit, int x, int y) {
    if (scene.tools().using(ToolKind.WAYPOINTS)) {
      pointed(hit.filter(h -> h.part().handle().isPresent()), x, y);
    }
    if (press.isEmpty()) {
      return;
    }
    hit.flatMap(h -> h.part().handle()).ifPresent(handles::gripped);
    grip = hit.flatMap(h -> h.part().handle()
        .map(handle -> new DragState(handle, scene.lens().ray(x, y), h.place(), parts.model()::soon)));
    if (grip.isEmpty()) {
      press = press.map(Press::turns);
    }
  }

  /**
   * With the tool for waypoints: a handle is selected, everything else is a place; the hand may have moved on or let go
   * meanwhile.
   */
  private void pointed(Optional<Pick> handle, int x, int y) {
    if (handle.isPresent()) {
      parts.model().soon(() -> parts.picks().select(handle.map(Picks::of)));
      return;
    }
    scene.tools().press(scene.lens(), x, y);
    press.ifPresentOrElse(p -> scene.tools().drag(scene.lens(), p.last().x, p.last().y), scene.tools()::release);
  }

  private void move(Event e) {
    pointer = new Point(e.x, e.y);
    if (press.isEmpty()) {
      display.timerExec(REST_MILLIS, rest);
      return;
    }
    Press before = press.get();
    press = Optional.of(before.at(e.x, e.y));
    if (grip.isPresent()) {
      grip.get().drag(scene.lens().ray(e.x, e.y));
    } else if (before.button() == 1 && scene.tools().points()) {
      scene.tools().drag(scene.lens(), e.x, e.y);
    } else if (measures(press.get())) {
      scene.tools().stretch(before.from(), pointer);
    } else if (press.get().moved() && before.turning()) {
      drag(before, e.x - before.last().x, e.y - before.last().y);
    }
  }

  private void drag(Press held, int dx, int dy) {
    boolean pans = held.button() == 2 || held.button() == 1 && held.shift();
    if (pans) {
      moveCamera(pose -> Moves.pan(lens(pose), dx, dy));
    } else if (held.button() == 1) {
      moveCamera(pose -> Moves.turn(pose, dx, dy));
    } else if (held.button() == 3) {
      moveCamera(pose -> Moves.zoom(lens(pose), held.from().x, held.from().y, Math.exp(dy * DRAG_ZOOM)));
    }
  }

  private void up(Event e) {
    Optional<Press> ended = press.filter(p -> p.button() == e.button);
    if (ended.isEmpty()) {
      return;
    }
    boolean still = !ended.get().moved();
    boolean gripping = grip.isPresent();
    letGo();
    if (e.button == 1 && scene.tools().points()) {
      scene.tools().release();
    } else if (e.button == 1 && !ended.get().shift() && scene.tools().using(ToolKind.MEASURE)) {
      measure(ended.get(), e);
    } else if (e.button == 1 && still && !gripping) {
      pick(e.x, e.y, hit -> clicked(hit, e.x, e.y));
    } else if (e.button == 3 && still) {
      openMenu(e.x, e.y);
    }
  }

  private boolean measures(Press held) {
    return held.button() == 1 && held.moved() && !held.shift() && scene.tools().using(ToolKind.MEASURE);
  }

  /** A click gives one end of a measure, a drag both. */
  private void measure(Press ended, Event e) {
    if (!ended.moved()) {
      place(e.x, e.y, spot -> spot.ifPresent(scene.tools()::measure));
      return;
    }
    place(ended.from().x, ended.from().y, from -> place(e.x, e.y, to -> scene.tools().measure(from, to)));
  }

  /** Selects; a handle that was let go before it was known to be one is clicked, too. */
  private void clicked(Optional<Pick> hit, int x, int y) {
    hit.ifPresent(h -> h.part().handle()
        .ifPresent(handle -> new DragState(handle, scene.lens().ray(x, y), h.place(), parts.model()::soon).release()));
    parts.model().soon(() -> parts.picks().select(hit.map(Picks::of)));
  }

  private void letGo() {
    grip.ifPresent(DragState::release);
    grip = Optional.empty();
    press = Optional.empty();
  }

  private void leave() {
    display.timerExec(-1, rest);
    parts.picks().hover(Optional.empty());
  }

  private void doubled() {
    if (scene.tools().kind().isEmpty()) {
      pick(pointer.x, pointer.y,
          hit -> hit.ifPresentOrElse(h -> scene.go(parts.rig().aim().at(h.place())), scene::fit));
    }
  }

  private void wheel(Event e) {
    e.doit = false;
    double factor = Math.pow(WHEEL_FACTOR, Integer.signum(e.count));
    moveCamera(pose -> Moves.zoom(lens(pose), e.x, e.y, factor));
  }

  /** By key; by mouse the menu opens when the button goes up, as a drag with it zooms. */
  private void menu(Event e) {
    e.doit = false;
    if (e.detail == SWT.MENU_KEYBOARD) {
      openMenu(pointer.x, pointer.y);
    }
  }

  private void openMenu(int x, int y) {
    pick(x, y, hit -> scene.menus().context(canvas, hit, hit.map(Pick::place).or(() -> scene.lens().level(x, y, 0))));
  }

  private void rested() {
    boolean slow = parts.studio().figures().filter(f -> f.seconds() > 0.1).isPresent();
    if (!canvas.isDisposed() && press.isEmpty() && !hovering && !slow) {
      hovering = true;
      pick(pointer.x, pointer.y, hit -> {
        hovering = false;
        parts.model().soon(() -> parts.picks().hover(hit.map(Picks::of)));
      });
    }
  }

  private void key(Event e) {
    if (waypoints.key(e) || handles.key(e.keyCode)) {
      return;
    }
    switch (e.keyCode) {
      case SWT.ARROW_LEFT -> moveCamera(pose -> Moves.turn(pose, KEY_TURN, 0));
      case SWT.ARROW_RIGHT -> moveCamera(pose -> Moves.turn(pose, -KEY_TURN, 0));
      case SWT.ARROW_UP -> moveCamera(pose -> Moves.turn(pose, 0, KEY_TURN));
      case SWT.ARROW_DOWN -> moveCamera(pose -> Moves.turn(pose, 0, -KEY_TURN));
      case SWT.HOME -> scene.fit();
      case SWT.ESC -> escape();
      default -> typed(Character.toLowerCase(e.character));
    }
  }

  private void typed(char character) {
    switch (character) {
      case '0' -> scene.fit();
      case '1' -> scene.go(parts.rig().aim().as(CameraKind.ORBIT));
      case '2' -> scene.go(parts.rig().aim().as(CameraKind.FLY));
      case '3' -> scene.go(parts.rig().aim().as(CameraKind.TOP));
      case '+', '=' -> zoomMiddle(WHEEL_FACTOR);
      case '-' -> zoomMiddle(1 / WHEEL_FACTOR);
      case 'f' -> scene.focusSelection();
      case 'g' -> scene.tools().toggle(ToolKind.GOAL);
      case 'l' -> scene.toggleTree();
      case 'm' -> scene.tools().toggle(ToolKind.MEASURE);
      case 'p' -> scene.tools().toggle(ToolKind.POSE);
      case 'r' -> scene.tools().toggle(ToolKind.WAYPOINTS);
      case 'v' -> scene.menus().camera(canvas);
      default -> walk(character);
    }
  }

  private void walk(char character) {
    switch (character) {
      case 'w' -> moveCamera(pose -> Moves.step(pose, 1, 0, 0));
      case 's' -> moveCamera(pose -> Moves.step(pose, -1, 0, 0));
      case 'a' -> moveCamera(pose -> Moves.step(pose, 0, 1, 0));
      case 'd' -> moveCamera(pose -> Moves.step(pose, 0, -1, 0));
      case 'e' -> moveCamera(pose -> Moves.step(pose, 0, 0, 1));
      case 'q' -> moveCamera(pose -> Moves.step(pose, 0, 0, -1));
      default -> {}
    }
  }

  private void escape() {
    letGo();
    if (!scene.tools().end()) {
      parts.picks().select(Optional.empty());
    }
    scene.refresh();
  }

  private void zoomMiddle(double factor) {
    moveCamera(pose -> Moves.zoom(lens(pose), lens(pose).width() / 2, lens(pose).height() / 2, factor));
  }

  private void moveCamera(UnaryOperator<CameraPose> change) {
    scene.touch();
    parts.rig().move(change);
    parts.studio().moved();
  }

  private Lens lens(CameraPose pose) {
    return scene.surface().lens(pose);
  }

  /** The place that was hit; else that on the floor, where there is one. */
  private void place(int x, int y, Consumer<Optional<Vector3>> then) {
    pick(x, y, hit -> then.accept(hit.map(Pick::place).or(() -> scene.lens().level(x, y, 0))));
  }

  private void pick(int x, int y, Consumer<Optional<Pick>> then) {
    double scale = scene.surface().scale();
    parts.studio().pick((int) (x * scale), (int) (y * scale)).whenComplete((hit, error) -> {
      if (!display.isDisposed()) {
        display.asyncExec(() -> {
          if (!canvas.isDisposed()) {
            then.accept(error == null ? hit : Optional.empty());
          }
        });
      }
    });
  }
}
