package org.robotui.ui.control;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import org.eclipse.swt.dnd.DND;
import org.eclipse.swt.dnd.DragSource;
import org.eclipse.swt.dnd.DragSourceAdapter;
import org.eclipse.swt.dnd.DragSourceEvent;
import org.eclipse.swt.dnd.TextTransfer;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.widgets.Control;
import org.robotui.ui.ViewAction;

/** What leaves a list: text to where it is dragged, and the menu of its rows. Display thread. */
final class RowExport {
  private RowExport() {}

  /** Has a control offer text where a drag begins at a point. */
  static void drag(Control control, Function<Integer, Optional<String>> textAt) {
    DragSource source = new DragSource(control, DND.DROP_COPY | DND.DROP_MOVE);
    source.setTransfer(TextTransfer.getInstance());
    source.addDragListener(new DragSourceAdapter() {
      private Optional<String> text = Optional.empty();

      @Override
      public void dragStart(DragSourceEvent event) {
        text = textAt.apply(event.y).filter(words -> !words.isEmpty());
        event.doit = text.isPresent();
      }

      @Override
      public void dragSetData(DragSourceEvent event) {
        event.data = text.orElse("");
      }
    });
  }

  /** Opens a menu at the pointer. */
  static void menu(Control control, int x, int y, List<ViewAction> actions) {
    menu(control, x, y, menu -> actions.forEach(menu::action));
  }

  /** Opens a menu at the pointer, unless it stays empty. */
  static void menu(Control control, int x, int y, Consumer<PopupMenu> fill) {
    PopupMenu menu = new PopupMenu(control);
    fill.accept(menu);
    menu.open(new Point(x, y));
  }
}
