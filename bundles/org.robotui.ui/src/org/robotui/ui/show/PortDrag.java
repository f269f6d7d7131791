package org.robotui.ui.show;

import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.eclipse.swt.dnd.DND;
import org.eclipse.swt.dnd.DragSource;
import org.eclipse.swt.dnd.DragSourceAdapter;
import org.eclipse.swt.dnd.DragSourceEvent;
import org.eclipse.swt.dnd.DropTarget;
import org.eclipse.swt.dnd.DropTargetAdapter;
import org.eclipse.swt.dnd.DropTargetEvent;
import org.eclipse.swt.dnd.TextTransfer;
import org.eclipse.swt.dnd.Transfer;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.show.Subject;

/**
 * Ports and their fields as they are dragged: from any list, onto any view that takes them, and as text into other
 * programs, which get the names that the robot uses. Display thread.
 */
public final class PortDrag {
  private PortDrag() {}

  /** Takes what is dropped. */
  public interface Target {
    /**
     * Something is held over the control, or is no more.
     *
     * @param at where, in the coordinates of the control; none when it has left or was dropped
     */
    default void over(Optional<Point> at) {}

    /**
     * Ports were dropped.
     *
     * @param ports of any RUIC
     * @param at where, in the coordinates of the control
     */
    void dropped(DraggedPorts ports, Point at);

    /**
     * A text was dropped, for example from an editor.
     *
     * @param text as it came
     * @param at where, in the coordinates of the control
     */
    default void dropped(String text, Point at) {}
  }

  /**
   * Lets ports be dragged out of a control.
   *
   * @param control for example a list
   * @param from is asked at the begin of a drag for what lies there; where there is nothing, nothing is dragged
   */
  public static void from(Control control, Function<Point, Optional<DraggedPorts>> from) {
    DragSource source = new DragSource(control, DND.DROP_COPY | DND.DROP_MOVE);
    source.setTransfer(new PortTransfer(), TextTransfer.getInstance());
    source.addDragListener(new DragSourceAdapter() {
      private Optional<DraggedPorts> ports = Optional.empty();

      @Override
      public void dragStart(DragSourceEvent event) {
        ports = from.apply(new Point(event.x, event.y)).filter(p -> !p.streams().isEmpty());
        event.doit = ports.isPresent();
      }

      @Override
      public void dragSetData(DragSourceEvent event) {
        boolean asText = TextTransfer.getInstance().isSupportedType(event.dataType);
        event.data = asText ? ports.map(PortDrag::text).orElse("") : ports.orElse(null);
      }
    });
  }

  /**
   * Lets ports be dropped on a control.
   *
   * @param control for example a canvas
   * @param texts whether texts are taken, too
   * @param taker what is done with them
   */
  public static void to(Control control, boolean texts, Target taker) {
    PortTransfer ports = new PortTransfer();
    DropTarget target = new DropTarget(control, DND.DROP_COPY | DND.DROP_MOVE | DND.DROP_LINK | DND.DROP_DEFAULT);
    target.setTransfer(texts ? new Transfer[]{ports, TextTransfer.getInstance()} : new Transfer[]{ports});
    target.addDropListener(new DropTargetAdapter() {
      @Override
      public void dragEnter(DropTargetEvent event) {
        if (event.detail == DND.DROP_DEFAULT) {
          event.detail = DND.DROP_COPY;
        }
      }

      @Override
      public void dragOver(DropTargetEvent event) {
        taker.over(Optional.of(at(event)));
      }

      @Override
      public void dragLeave(DropTargetEvent event) {
        taker.over(Optional.empty());
      }

      @Override
      public void drop(DropTargetEvent event) {
        taker.over(Optional.empty());
        if (event.data instanceof DraggedPorts dragged) {
          taker.dropped(dragged, at(event));
        } else if (event.data instanceof String text) {
          taker.dropped(text, at(event));
        }
      }

      private Point at(DropTargetEvent event) {
        return control.toControl(event.x, event.y);
      }
    });
  }

  /**
   * What a stream is called outside of the workbench.
   *
   * @param stream a port, with fields or without
   * @return the robot's name for it, a line for each field
   */
  public static String name(Subject.Stream stream) {
    return stream.fields().isEmpty() ? stream.port().port()
        : stream.fields().stream().map(field -> stream.port() + ":" + field).collect(Collectors.joining("\n"));
  }

  private static String text(DraggedPorts ports) {
    return ports.streams().stream().map(PortDrag::name).collect(Collectors.joining("\n"));
  }
}
