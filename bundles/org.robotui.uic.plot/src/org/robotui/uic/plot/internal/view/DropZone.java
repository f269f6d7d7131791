package org.robotui.uic.plot.internal.view;

import java.util.Optional;
import java.util.function.BiConsumer;
import org.eclipse.swt.dnd.DND;
import org.eclipse.swt.dnd.DropTarget;
import org.eclipse.swt.dnd.DropTargetAdapter;
import org.eclipse.swt.dnd.DropTargetEvent;
import org.eclipse.swt.dnd.TextTransfer;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Canvas;
import org.robotui.ui.Theme;

/** Takes signals that are dropped on the view, as texts; shows to which axis they would go. Display thread. */
final class DropZone {
  private final Canvas canvas;
  private final PlotPainter painter;
  private final BiConsumer<String, Integer> dropped;
  private Optional<Point> over = Optional.empty();

  DropZone(Canvas canvas, PlotPainter painter, BiConsumer<String, Integer> dropped) {
    this.canvas = canvas;
    this.painter = painter;
    this.dropped = dropped;
    DropTarget target = new DropTarget(canvas, DND.DROP_COPY | DND.DROP_MOVE | DND.DROP_LINK | DND.DROP_DEFAULT);
    target.setTransfer(TextTransfer.getInstance());
    target.addDropListener(new Listener());
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
      return new Rectangle(area.x + Theme.EDGE, area.y + Theme.EDGE, area.width - 2 * Theme.EDGE, area.height - 2 * Theme.EDGE);
    }
    int height = Frames.TIMES;
    return new Rectangle(area.x, area.y + area.height - height, area.width, height);
  }

  private final class Listener extends DropTargetAdapter {
    @Override
    public void dragEnter(DropTargetEvent event) {
      if (event.detail == DND.DROP_DEFAULT) {
        event.detail = DND.DROP_COPY;
      }
    }

    @Override
    public void dragOver(DropTargetEvent event) {
      over = Optional.of(canvas.toControl(event.x, event.y));
      canvas.redraw();
    }

    @Override
    public void dragLeave(DropTargetEvent event) {
      over = Optional.empty();
      canvas.redraw();
    }

    @Override
    public void drop(DropTargetEvent event) {
      over = Optional.empty();
      if (event.data instanceof String text) {
        dropped.accept(text, axisAt(canvas.toControl(event.x, event.y)));
      }
      canvas.redraw();
    }
  }
}
