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
    void signals(String text, Place place);

    /** Adds ports to an axis, or asks which of their fields. */
    void ports(DraggedPorts ports, Place place, Point at);
  }

  /** An axis, a new one where there are fewer; and whether what is dropped becomes its horizontal scale. */
  record Place(int axis, boolean across) {}

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

  /** The axis at a point; below its plot, its horizontal scale; a new one outside of all. */
  Place placeAt(Point point) {
    return painter.frames().stream()
        .filter(f -> f.plot().contains(point) || f.legend().contains(point) || f.times().contains(point)).findFirst()
        .map(f -> new Place(f.index(), f.times().contains(point))).orElse(new Place(painter.frames().size(), false));
  }

  /** Whether something is held over the view. */
  boolean isOver() {
    return over.isPresent();
  }

  void paint(GC gc, Rectangle area) {
    over.ifPresent(point -> {
      Place place = placeAt(point);
      boolean isNew = place.axis() >= painter.frames().size();
      if (place.across()) {
        painter.target(gc, painter.frames().get(place.axis()).times(), "Plot over this");
      } else {
        painter.target(gc, isNew ? all(area) : painter.frames().get(place.axis()).plot(),
            isNew ? "New axis" : "Add to this axis");
      }
    });
  }

  private static Rectangle all(Rectangle area) {
    return new Rectangle(area.x + Theme.EDGE, area.y + Theme.EDGE, area.width - 2 * Theme.EDGE,
        area.height - 2 * Theme.EDGE);
  }

  @Override
  public void over(Optional<Point> at) {
    over = at;
    canvas.redraw();
  }

  @Override
  public void dropped(DraggedPorts ports, Point at) {
    taker.ports(ports, placeAt(at), at);
  }

  @Override
  public void dropped(String text, Point at) {
    taker.signals(text, placeAt(at));
  }
}
