package org.robotui.uic.plot.internal.view;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Canvas;
import org.eclipse.swt.widgets.Event;
import org.robotui.uic.plot.internal.model.CursorPair;
import org.robotui.uic.plot.internal.model.PlotScene;
import org.robotui.uic.plot.internal.model.Replay;
import org.robotui.uic.plot.internal.model.TimeView;
import org.robotui.uic.plot.internal.model.ValueSpan;
import org.robotui.uic.plot.internal.trace.TimeSpan;

/**
 * Looks around (over time; curves are moved and zoomed by their values, see {@link CurveZoom}): drag moves time, wheel
 * zooms time, with shift or control values; a drag with shift marks a box to zoom into; over the figures of a scale
 * drag and wheel move and zoom values; double click goes back to live. Display thread.
 */
final class Navigation {
  private static final double STEP = 1.25;
  private static final int STILL = 3;
  private static final int LEAST_BOX = 6;
  private static final double KEY_SHARE = 0.1;

  private final Canvas canvas;
  private final Supplier<PlotScene> scene;
  private final PlotState state;
  private final PlotPainter painter;
  private final CurveZoom zoom;
  private Optional<Drag> drag = Optional.empty();
  private Optional<Long> before = Optional.empty();
  private boolean dragged;

  Navigation(Canvas canvas, Supplier<PlotScene> scene, PlotState state, PlotPainter painter) {
    this.canvas = canvas;
    this.scene = scene;
    this.state = state;
    this.painter = painter;
    this.zoom = new CurveZoom(state);
  }

  private enum Kind {
    TIME, VALUES, BOX, CURSOR_A, CURSOR_B, POSITION, CURVE
  }

  /** What is held, since where, and how all lay then. */
  private record Drag(Kind kind, AxisFrame frame, Point start) {}

  void listen() {
    canvas.addListener(SWT.MouseDown, this::down);
    canvas.addListener(SWT.MouseMove, this::move);
    canvas.addListener(SWT.MouseUp, this::up);
    canvas.addListener(SWT.MouseExit, e -> point(Optional.empty()));
    canvas.addListener(SWT.MouseDoubleClick, e -> back(new Point(e.x, e.y)));
    canvas.addListener(SWT.MouseVerticalWheel, this::wheel);
    canvas.addListener(SWT.MouseHorizontalWheel, e -> shift(e.count > 0 ? -KEY_SHARE : KEY_SHARE));
    canvas.addListener(SWT.KeyDown, this::key);
    canvas.addListener(SWT.Traverse,
        e -> e.doit = e.detail == SWT.TRAVERSE_TAB_NEXT || e.detail == SWT.TRAVERSE_TAB_PREVIOUS);
  }

  /** Holds what is seen, or goes back to live; of recordings: or goes along with their position. */
  void pause() {
    if (scene.get().replay().isPresent()) {
      if (state.isFollowing()) {
        state.hold(scene.get());
      } else {
        state.follow(scene.get());
      }
    } else if (state.isLive()) {
      state.hold(scene.get());
    } else {
      state.live();
    }
    canvas.redraw();
  }

  void live() {
    state.live();
    canvas.redraw();
  }

  /** Shows two cursors, or takes them away. */
  void cursors() {
    state.cursors(
        state.cursors().isPresent() ? Optional.empty() : Optional.of(CursorPair.within(state.span(scene.get(), 0))));
    canvas.redraw();
  }

  private void down(Event event) {
    canvas.setFocus();
    dragged = false;
    if (event.button == 1 || event.button == 2) {
      drag = at(new Point(event.x, event.y)).flatMap(frame -> grab(event, frame));
    }
  }

  private Optional<Drag> grab(Event event, AxisFrame frame) {
    Point start = new Point(event.x, event.y);
    if (frame.isCurve() && (event.stateMask & SWT.SHIFT) == 0) {
      return Optional.of(new Drag(Kind.CURVE, frame, start));
    }
    if (!frame.plot().contains(start)) {
      return Optional.of(new Drag(Kind.VALUES, frame, start));
    }
    Optional<CursorPair> cursors = state.cursors().filter(c -> !frame.isCurve());
    if (event.button == 1 && cursors.filter(c -> PointerPainter.near(frame, c.b(), event.x)).isPresent()) {
      return Optional.of(new Drag(Kind.CURSOR_B, frame, start));
    }
    if (event.button == 1 && cursors.filter(c -> PointerPainter.near(frame, c.a(), event.x)).isPresent()) {
      return Optional.of(new Drag(Kind.CURSOR_A, frame, start));
    }
    boolean position = event.button == 1 && !frame.isCurve() && scene.get().replay()
        .filter(replay -> PointerPainter.near(frame, replay.position(), event.x)).isPresent();
    if (position) {
      return Optional.of(new Drag(Kind.POSITION, frame, start));
    }
    boolean box = event.button == 1 && (event.stateMask & SWT.SHIFT) != 0;
    return Optional.of(new Drag(box ? Kind.BOX : Kind.TIME, frame, start));
  }

  private void move(Event event) {
    Point here = new Point(event.x, event.y);
    drag.ifPresent(d -> drag(d, here));
    point(Optional.of(here));
  }

  private void point(Optional<Point> here) {
    state.pointer(here);
    canvas.redraw();
  }

  private void drag(Drag d, Point here) {
    switch (d.kind()) {
      case CURSOR_A -> state.cursors(state.cursors().map(c -> c.withA(d.frame().time(here.x))));
      case CURSOR_B -> state.cursors(state.cursors().map(c -> c.withB(d.frame().time(here.x))));
      case BOX -> state.box(Optional.of(box(d, here)));
      case POSITION -> seek(d.frame().time(Math.clamp(here.x, d.frame().plot().x,
          d.frame().plot().x + d.frame().plot().width)));
      case TIME -> dragTime(d, here);
      case CURVE -> {
        dragged |= Math.abs(here.x - d.start().x) > STILL || Math.abs(here.y - d.start().y) > STILL;
        if (dragged) {
          zoom.moved(d.frame(), here.x - d.start().x, here.y - d.start().y);
        }
      }
      case VALUES -> dragValues(d, here.y - d.start().y, true);
    }
  }

  private void dragTime(Drag d, Point here) {
    int dx = here.x - d.start().x;
    dragged |= Math.abs(dx) > STILL || Math.abs(here.y - d.start().y) > STILL;
    if (dragged || !state.isLive() && scene.get().replay().isEmpty()) {
      long moved = d.frame().time((double) -dx);
      state.time(scene.get(), d.frame().index(),
          state.time(scene.get(), d.frame().index()).moved(d.frame().span(), moved));
    }
    dragValues(d, here.y - d.start().y, false);
  }

  private void dragValues(Drag d, int dy, boolean always) {
    for (boolean right : new boolean[]{false, true}) {
      if (always || state.isZoomed(d.frame().index(), right)) {
        ValueSpan from = d.frame().values(right);
        state.zoom(d.frame().index(), right, from.moved(from.length() * dy / Math.max(1, d.frame().plot().height)));
      }
    }
  }

  private static Rectangle box(Drag d, Point here) {
    Rectangle plot = d.frame().plot();
    int x = Math.clamp(here.x, plot.x, plot.x + plot.width);
    int y = Math.clamp(here.y, plot.y, plot.y + plot.height);
    return new Rectangle(Math.min(x, d.start().x), Math.min(y, d.start().y), Math.abs(x - d.start().x),
        Math.abs(y - d.start().y));
  }

  private void seek(long time) {
    scene.get().replay().ifPresent(replay -> replay.timeline().seek(time));
  }

  /** A click into a plot of recordings goes to that time. */
  private void clicked(Drag d) {
    boolean still =
        !dragged && (d.kind() == Kind.TIME || d.kind() == Kind.CURVE && d.frame().plot().contains(d.start()));
    if (still) {
      before = scene.get().replay().map(Replay::position);
      painter.timeAt(d.frame(), d.start()).ifPresent(this::seek);
    }
  }

  private void up(Event event) {
    drag.filter(d -> event.button == 1).ifPresent(this::clicked);
    drag.filter(d -> d.kind() == Kind.BOX).ifPresent(d -> state.box().ifPresent(box -> zoomInto(d.frame(), box)));
    drag = Optional.empty();
    state.box(Optional.empty());
    canvas.redraw();
  }

  private void zoomInto(AxisFrame frame, Rectangle box) {
    if (box.width < LEAST_BOX || box.height < LEAST_BOX) {
      return;
    }
    int axis = frame.index();
    if (frame.isCurve()) {
      zoom.into(frame, box);
      return;
    }
    TimeSpan span = new TimeSpan(frame.time(box.x), Math.max(frame.time(box.x) + 1, frame.time(box.x + box.width)));
    state.time(scene.get(), axis, state.time(scene.get(), axis).hold(span));
    for (boolean right : new boolean[]{false, true}) {
      double low = frame.value(box.y + box.height, right);
      double high = frame.value(box.y, right);
      if (low < high) {
        state.zoom(axis, right, new ValueSpan(low, high));
      }
    }
  }

  private void back(Point point) {
    if (at(point).isPresent()) {
      before.ifPresent(this::seek); // it was no click
      before = Optional.empty();
      live();
    }
  }

  private void wheel(Event event) {
    Point point = new Point(event.x, event.y);
    double factor = event.count > 0 ? 1 / STEP : STEP;
    at(point).ifPresent(frame -> {
      if (frame.isCurve()) {
        zoom.zoomed(frame, factor, point);
        canvas.redraw();
        return;
      }
      boolean values = (event.stateMask & (SWT.SHIFT | SWT.CTRL)) != 0 || !frame.plot().contains(point);
      if (values) {
        zoomValues(frame, factor, point.y);
      } else {
        zoomTime(frame, factor, point.x);
      }
    });
    event.doit = false;
  }

  private void zoomTime(AxisFrame frame, double factor, int x) {
    int axis = frame.index();
    TimeSpan seen = state.span(scene.get(), axis);
    TimeView view = state.time(scene.get(), axis);
    boolean goesOn = scene.get().replay().isEmpty() || view.isFollowing();
    state.time(scene.get(), axis, (goesOn ? view : view.hold(seen)).zoomed(seen, factor, frame.time(x)));
    canvas.redraw();
  }

  private void zoomValues(AxisFrame frame, double factor, int y) {
    state.zoom(frame.index(), false, frame.left().zoomed(factor, frame.value(y, false)));
    frame.right().ifPresent(right -> state.zoom(frame.index(), true, right.zoomed(factor, frame.value(y, true))));
    canvas.redraw();
  }

  /** The axis at a point: its plot, or the figures beside it. */
  private Optional<AxisFrame> at(Point point) {
    return painter.frames().stream().filter(f -> {
      Rectangle plot = f.plot();
      boolean legend = f.legend().contains(point);
      int figures = f.isCurve() ? f.times().height : 0;
      return !legend && point.y >= plot.y && point.y < plot.y + plot.height + figures;
    }).findFirst();
  }

  private void key(Event event) {
    switch (event.keyCode) {
      case '+', '=', SWT.KEYPAD_ADD -> keyZoom(1 / STEP);
      case '-', SWT.KEYPAD_SUBTRACT -> keyZoom(STEP);
      case SWT.ARROW_LEFT -> shift(-KEY_SHARE);
      case SWT.ARROW_RIGHT -> shift(KEY_SHARE);
      case SWT.ARROW_UP -> keyValues(event, KEY_SHARE);
      case SWT.ARROW_DOWN -> keyValues(event, -KEY_SHARE);
      case '0', SWT.HOME -> live();
      case 'p' -> pause();
      case 'c' -> cursors();
      case SWT.ESC -> {
        drag = Optional.empty();
        state.box(Optional.empty());
        canvas.redraw();
      }
      default -> {}
    }
  }

  private void keyZoom(double factor) {
    List<AxisFrame> overTime = painter.frames().stream().filter(f -> !f.isCurve()).toList();
    if (overTime.isEmpty()) {
      painter.frames().forEach(f -> zoom.zoomed(f, factor, CurveZoom.middle(f)));
    }
    overTime.stream().findFirst().ifPresent(f -> zoomTime(f, factor, scene.get().replay().map(Replay::position)
        .filter(f.span()::contains).map(position -> Math.round(f.x(position)))
        .orElse(f.plot().x + f.plot().width / 2)));
    canvas.redraw();
  }

  private void keyValues(Event event, double share) {
    for (AxisFrame frame : painter.frames()) {
      if ((event.stateMask & SWT.SHIFT) != 0) {
        zoomValues(frame, share > 0 ? 1 / STEP : STEP, frame.plot().y + frame.plot().height / 2);
      } else {
        dragValues(new Drag(Kind.VALUES, frame, new Point(0, 0)), (int) Math.round(share * frame.plot().height), true);
      }
    }
    canvas.redraw();
  }

  private void shift(double share) {
    boolean onlyCurves = painter.frames().stream().allMatch(AxisFrame::isCurve);
    for (AxisFrame frame : painter.frames()) {
      if (onlyCurves) {
        zoom.moved(frame, (int) Math.round(-share * frame.plot().width), 0);
      } else if (frame.index() == 0 || !scene.get().spec().linked()) {
        TimeSpan seen = state.span(scene.get(), frame.index());
        state.time(scene.get(), frame.index(),
            state.time(scene.get(), frame.index()).moved(seen, Math.round(seen.length() * share)));
      }
    }
    canvas.redraw();
  }
}
