package org.robotui.ui.control;

import java.util.List;
import java.util.function.Consumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Canvas;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Event;
import org.robotui.api.port.SourceId;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.HealthDot;
import org.robotui.ui.Icon;
import org.robotui.ui.Icons;
import org.robotui.ui.Role;
import org.robotui.ui.SpaceKey;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;

/**
 * Asks which of several ports is meant: a sentence and a row per candidate, chosen by a click or by arrow keys and
 * enter. Display thread only.
 */
public final class CandidateChooser extends Canvas {
  private static final int ROW = 30;
  private static final int HEAD = 52;
  private static final int WIDEST = 420;
  private static final int CORNER = 8;

  private final Theme theme;
  private final Consumer<SourceId> chosen;
  private String question = "";
  private List<SourceId> candidates = List.of();
  private int marked;
  private int first;

  /**
   * A chooser that shows nothing yet.
   *
   * @param parent the parent
   * @param theme colours and fonts
   * @param chosen is given what the user chose
   */
  public CandidateChooser(Composite parent, Theme theme, Consumer<SourceId> chosen) {
    super(parent, SWT.DOUBLE_BUFFERED);
    this.theme = theme;
    this.chosen = chosen;
    setBackground(theme.color(Role.PANEL));
    addPaintListener(e -> paint(e.gc, getClientArea()));
    SpaceKey.claim(this);
    addListener(SWT.MouseMove, e -> hover(e.y));
    addListener(SWT.MouseUp, this::click);
    addListener(SWT.MouseVerticalWheel, e -> mark(marked - Integer.signum(e.count)));
    addListener(SWT.KeyDown, this::key);
    addListener(SWT.FocusIn, e -> redraw());
    addListener(SWT.FocusOut, e -> redraw());
    addListener(SWT.Traverse, e -> e.doit = e.detail == SWT.TRAVERSE_TAB_NEXT || e.detail == SWT.TRAVERSE_TAB_PREVIOUS);
  }

  /**
   * Asks.
   *
   * @param sentence why the user is asked
   * @param ports what can be chosen
   */
  public void ask(String sentence, List<SourceId> ports) {
    if (!sentence.equals(question) || !ports.equals(candidates)) {
      question = sentence;
      candidates = List.copyOf(ports);
      mark(marked);
      redraw();
    }
  }

  private void mark(int index) {
    marked = Math.clamp(index, 0, Math.max(0, candidates.size() - 1));
    int seen = seen(getClientArea().height);
    first = Math.clamp(first, Math.max(0, marked - seen + 1), marked);
    redraw();
  }

  private static int seen(int height) {
    return Math.max(1, (height - HEAD) / ROW);
  }

  private void hover(int y) {
    int row = rowAt(y);
    setCursor(row >= 0 ? getDisplay().getSystemCursor(SWT.CURSOR_HAND) : null);
    if (row >= 0 && row != marked) {
      mark(row);
    }
  }

  private void click(Event event) {
    int row = rowAt(event.y);
    if (event.button == 1 && row >= 0) {
      choose(row);
    }
  }

  private void key(Event event) {
    switch (event.keyCode) {
      case SWT.ARROW_UP -> mark(marked - 1);
      case SWT.ARROW_DOWN -> mark(marked + 1);
      case SWT.CR, SWT.KEYPAD_CR, ' ' -> choose(marked);
      default -> {}
    }
  }

  private void choose(int row) {
    if (row < candidates.size()) {
      chosen.accept(candidates.get(row));
    }
  }

  private int rowAt(int y) {
    int row = Math.floorDiv(y - top(getClientArea()), ROW) + first;
    return row >= first && row < candidates.size() ? row : -1;
  }

  private int top(Rectangle area) {
    int shown = Math.min(candidates.size(), seen(area.height));
    return Math.max(0, (area.height - HEAD - shown * ROW) / 2) + HEAD;
  }

  private void paint(GC gc, Rectangle area) {
    int width = Math.min(WIDEST, area.width - 2 * Theme.EDGE);
    int left = area.x + (area.width - width) / 2;
    int top = top(area);
    head(gc, left, top - HEAD, width);
    int last = Math.min(candidates.size(), first + seen(area.height));
    for (int i = first; i < last; i++) {
      row(gc, new Rectangle(left, top + (i - first) * ROW, width, ROW), i);
    }
  }

  private void head(GC gc, int left, int top, int width) {
    gc.setFont(theme.font(Face.BODY_STRONG));
    gc.setForeground(theme.color(Role.TEXT));
    HealthDot.paint(gc, theme, Health.NONE, left + HealthDot.SIZE / 2, top + 10);
    gc.setForeground(theme.color(Role.TEXT));
    gc.drawText("Which one?", left + HealthDot.SIZE + 2 * Theme.STEP, top, true);
    gc.setFont(theme.font(Face.BODY));
    gc.setForeground(theme.color(Role.DIM));
    gc.drawText(TextFit.shorten(gc, question, width), left, top + 22, true);
    setToolTipText(gc.textExtent(question).x > width ? question : null);
  }

  private void row(GC gc, Rectangle at, int index) {
    boolean hot = index == marked;
    if (hot) {
      gc.setBackground(theme.mix(Role.ACCENT, Role.PANEL, isFocusControl() ? 0.28 : 0.16));
      gc.fillRoundRectangle(at.x, at.y, at.width, at.height, CORNER, CORNER);
    }
    gc.setForeground(theme.color(hot ? Role.ACCENT : Role.DIM));
    Icons.paint(gc, Icon.LINK, at.x + 2 * Theme.STEP, at.y + (at.height - Icons.SIZE) / 2, Icons.SIZE);
    SourceId candidate = candidates.get(index);
    gc.setFont(theme.font(Face.BODY));
    Point size = gc.textExtent(candidate.component());
    int middle = at.y + (at.height - size.y) / 2;
    int right = at.x + at.width - 2 * Theme.STEP;
    gc.setForeground(theme.color(Role.DIM));
    gc.drawText(candidate.component(), right - size.x, middle, true);
    gc.setForeground(theme.color(Role.TEXT));
    int text = at.x + Icons.SIZE + 4 * Theme.STEP;
    gc.drawText(TextFit.shorten(gc, candidate.port(), right - size.x - text - Theme.EDGE), text, middle, true);
  }
}
