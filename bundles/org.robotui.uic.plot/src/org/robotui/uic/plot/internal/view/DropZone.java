package org.robotui.uic.plot.internal.view;

import java.util.Optional;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Canvas;
import org.robotui.ui.Theme;
import org.robotui.ui.show.DraggedPorts;
import org.robotui.ui.show.PortDrag;

/** Takes ports and signals that are dropped on the view; shows to which axis they would go. Display thread. */
final class DropZone implements PortDrag.Target {
  /** What is done with what was dropped. */
  interface Taker {
    /** Adds signals, one a line, to an axis. */
    void signals(String text, int axis);

    /** Adds ports to an axis, or asks which of their fields. */
    void ports(DraggedPorts ports, int axis, Point at);
  }

  private final Canvas canvas;
  private final PlotPainter painter;
  private final Taker taker;
  private Optional<Point> over = Optional.empty();

  DropZone(Canvas canvas, PlotPainter painter, Taker taker) {
    this.canvas = canvas;
    this.painter = painter;
    this.taker = taker;
    PortDrag.to(canvas, true, this);
  }

  /** The axis at a point; a new one outside of all. */
  int axisAt(Point point) {
    return painter.frames().stream().filter(f -> f.plot().contains(point) || f.legend().contains(point))
        .findFirst().map(AxisFrame::index).orElse(painter.frames().size());
  }

  /** Whether something is held over the view. */
  boolean isOver() {
    return over.isPresent();
  }

  void paint(GC gc, Rectangle area) {
    over.ifPresent(point -> {
      int axis = axisAt(point);
      boolean isNew = axis >= painter.frames().size();
      Rectangle at = isNew ? below(area) : painter.frames().get(axis).plot();
      painter.target(gc, at, isNew ? "New axis" : "Add to this axis");
    });
  }

  private Rectangle below(Rectangle area) {
    if (painter.frames().isEmpty()) {
      return new Rectangle(area.x + Theme.EDGE, area.y + Theme.EDGE, area.width - 2 * Theme.EDGE,
          area.height - 2 * Theme.EDGE);
    }
    int height = Frames.TIMES;
    return new Rectangle(area.x, area.y + area.height - height, area.width, height);
  }

  @Override
  public void over(Optional<Point> at) {
    over = at;
    canvas.redraw();
  }

  @Override
  public void dropped(DraggedPorts ports, Point at) {
    taker.ports(ports, axisAt(at), at);
  }

  @Override
  public void dropped(String text, Point at) {
    taker.signals(text, axisAt(at));
  }
}
