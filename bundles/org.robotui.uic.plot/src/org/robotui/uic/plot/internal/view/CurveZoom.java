package org.robotui.uic.plot.internal.view;

import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.uic.plot.internal.model.ValueSpan;

/** Moves and zooms axes that show curves: both of their scales at once. Display thread. */
final class CurveZoom {
  private final PlotState state;

  CurveZoom(PlotState state) {
    this.state = state;
  }

  static Point middle(AxisFrame frame) {
    return new Point(frame.plot().x + frame.plot().width / 2, frame.plot().y + frame.plot().height / 2);
  }

  /** By so many points of the screen since a frame was so. */
  void moved(AxisFrame from, int dx, int dy) {
    ValueSpan across = from.across().orElseThrow();
    state.zoomAcross(from.index(), across.moved(-across.length() * dx / Math.max(1, from.plot().width)));
    state.zoom(from.index(), false, from.left().moved(from.left().length() * dy / Math.max(1, from.plot().height)));
    from.right().ifPresent(right -> state.zoom(from.index(), true,
        right.moved(right.length() * dy / Math.max(1, from.plot().height))));
  }

  /** What lies at the point stays there; over the figures of a scale, that scale alone changes where units differ. */
  void zoomed(AxisFrame frame, double factor, Point at) {
    boolean below = at.y >= frame.plot().y + frame.plot().height;
    boolean beside = at.x < frame.plot().x || at.x >= frame.plot().x + frame.plot().width;
    if (!beside) {
      state.zoomAcross(frame.index(), frame.across().orElseThrow().zoomed(factor, frame.valueAcross(at.x)));
    }
    if (!below) {
      state.zoom(frame.index(), false, frame.left().zoomed(factor, frame.value(at.y, false)));
      frame.right().ifPresent(
          right -> state.zoom(frame.index(), true, right.zoomed(factor, frame.value(at.y, true))));
    }
  }

  /** Shows what lies within a box, and more where both scales are equal. */
  void into(AxisFrame frame, Rectangle box) {
    int axis = frame.index();
    state.zoomAcross(axis, new ValueSpan(frame.valueAcross(box.x), frame.valueAcross(box.x + box.width)));
    state.zoom(axis, false, new ValueSpan(frame.value(box.y + box.height, false), frame.value(box.y, false)));
    frame.right().ifPresent(right -> state.zoom(axis, true,
        new ValueSpan(frame.value(box.y + box.height, true), frame.value(box.y, true))));
  }
}
