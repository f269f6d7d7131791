package org.robotui.ui.control;

import java.util.Optional;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.api.port.InputState;
import org.robotui.ui.Health;
import org.robotui.ui.Role;
import org.robotui.ui.StateView;
import org.robotui.ui.Theme;

/** Paints what is seen of a list, or why nothing is. Display thread. */
final class RowPaint<R> {
  private static final double HOVERED = 0.05;
  private static final double MARKED = 0.08;
  private static final double MARKED_IN_FOCUS = 0.22;
  private static final int OPAQUE = 255;

  private final RowList<R> list;
  private final Theme theme;
  private final StateView states;
  private Optional<InputState> state = Optional.empty();
  private Optional<Message> message = Optional.empty();
  private int hot = -1;

  RowPaint(RowList<R> list, Theme theme) {
    this.list = list;
    this.theme = theme;
    states = new StateView(theme);
  }

  /** What is said in place of rows. */
  record Message(Health health, String title, String sentence) {}

  /** Whether that is news. */
  boolean state(InputState next) {
    boolean news = !state.equals(Optional.of(next));
    state = Optional.of(next);
    return news;
  }

  /** Whether that is news. */
  boolean message(Optional<Message> next) {
    boolean news = !message.equals(next);
    message = next;
    return news;
  }

  /** Whether that is news. */
  boolean hover(int index) {
    boolean news = hot != index;
    hot = index;
    return news;
  }

  void paint(GC gc, Rectangle area) {
    if (message.isPresent()) {
      Message said = message.get();
      states.message(gc, area, said.health(), said.title(), said.sentence());
      return;
    }
    if (state.map(StateView::showsContent).orElse(true)) {
      gc.setAlpha(state.map(StateView::contentAlpha).orElse(OPAQUE));
      rows(gc);
      gc.setAlpha(OPAQUE);
    }
    state.ifPresent(
        s -> states.paint(gc, s instanceof InputState.Stale ? StateView.belowRows(area, rowsEnd()) : area, s));
  }

  private int rowsEnd() {
    int end = list.scroll().end();
    return end > list.scroll().first() ? list.at(end - 1).y + list.at(end - 1).height : 0;
  }

  private void rows(GC gc) {
    int end = list.scroll().end();
    for (int i = list.scroll().first(); i < end; i++) {
      ground(gc, list.at(i), i);
      list.look().paint(gc, list.at(i), list.rows().get(i));
    }
  }

  private void ground(GC gc, Rectangle at, int index) {
    R row = list.rows().get(index);
    boolean focus = list.canvas().isFocusControl();
    if (list.marks().has(row)) {
      gc.setBackground(
          focus ? theme.mix(Role.ACCENT, Role.PANEL, MARKED_IN_FOCUS) : theme.mix(Role.TEXT, Role.PANEL, MARKED));
      gc.fillRectangle(at);
    } else if (index == hot) {
      gc.setBackground(theme.mix(Role.TEXT, Role.PANEL, HOVERED));
      gc.fillRectangle(at);
    }
    if (focus && list.input().isSeveral() && list.marks().leads(row)) {
      gc.setForeground(theme.color(Role.ACCENT));
      gc.setLineWidth(1);
      gc.drawRectangle(at.x, at.y, at.width - 1, at.height - 1);
    }
  }
}
