package org.robotui.uic.log.internal.view;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.eclipse.swt.SWT;
import org.eclipse.swt.accessibility.AccessibleAdapter;
import org.eclipse.swt.accessibility.AccessibleEvent;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.robotui.data.status.Severity;
import org.robotui.ui.Face;
import org.robotui.ui.HealthDot;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.SpaceKey;
import org.robotui.ui.Theme;
import org.robotui.uic.log.internal.model.Wording;

/**
 * The levels with their counts; a click or space shows or hides one, which is struck out then. Display thread.
 */
final class LevelBar {
  static final int HEIGHT = 26;

  private static final int GAP = 4;
  private static final int CORNER = 10;
  private static final int INSET = 8;
  private static final int DOT = HealthDot.SIZE + 6;
  private static final int FIGURES = 32;
  private static final int THOUSANDS = 10_000;
  private static final double GROUND = 0.07;
  private static final double HOT = 0.13;
  private static final List<Severity> ALL = Arrays.asList(Severity.values());

  private final PaintedCanvas canvas;
  private final Theme theme;
  private final Consumer<Severity> toggled;
  private final int full;
  private final int[] edges = new int[ALL.size() + 1];
  private Map<Severity, Integer> counts = Map.of();
  private Set<Severity> shown = Set.of();
  private int hot = -1;
  private int marked;

  LevelBar(Composite parent, Theme theme, Consumer<Severity> toggled) {
    this.theme = theme;
    this.toggled = toggled;
    canvas = new PaintedCanvas(parent, theme, this::paint);
    SpaceKey.claim(canvas);
    full = measure(FIGURES);
    canvas.addListener(SWT.Resize, e -> measure(canvas.getSize().x < full ? 0 : FIGURES));
    canvas.addListener(SWT.MouseMove, e -> hover(at(e.x)));
    canvas.addListener(SWT.MouseExit, e -> hover(-1));
    canvas.addListener(SWT.MouseUp, this::released);
    canvas.addListener(SWT.KeyDown, this::key);
    canvas.addListener(SWT.FocusIn, e -> canvas.redraw());
    canvas.addListener(SWT.FocusOut, e -> canvas.redraw());
    canvas.addListener(SWT.Traverse,
        e -> e.doit = e.detail == SWT.TRAVERSE_TAB_NEXT || e.detail == SWT.TRAVERSE_TAB_PREVIOUS);
    canvas.getAccessible().addAccessibleListener(new AccessibleAdapter() {
      @Override
      public void getName(AccessibleEvent e) {
        e.result = words();
      }
    });
  }

  Control control() {
    return canvas;
  }

  /** How wide it is with counts; where there is less room, it does without. */
  int width() {
    return full;
  }

  void show(Map<Severity, Integer> nextCounts, Set<Severity> nextShown) {
    if (!counts.equals(nextCounts) || !shown.equals(nextShown)) {
      counts = nextCounts;
      shown = nextShown;
      canvas.redraw();
    }
  }

  /** A count in at most four characters, so that nothing moves. */
  static String count(int number) {
    return number < THOUSANDS ? Integer.toString(number) : number / 1000 + "k";
  }

  private String words() {
    return ALL.stream()
        .map(s -> Wording.word(s) + " " + counts.getOrDefault(s, 0) + (shown.contains(s) ? " shown" : " hidden"))
        .collect(Collectors.joining(", "));
  }

  private int measure(int figures) {
    GC gc = new GC(canvas);
    gc.setFont(theme.font(Face.BODY));
    for (int i = 0; i < ALL.size(); i++) {
      int dot = Severities.dot(ALL.get(i)).isPresent() ? DOT : 0;
      edges[i + 1] = edges[i] + INSET + dot + gc.textExtent(Wording.word(ALL.get(i))).x + figures + INSET + GAP;
    }
    gc.dispose();
    return edges[ALL.size()];
  }

  private void paint(GC gc, Rectangle area) {
    for (int i = 0; i < ALL.size(); i++) {
      chip(gc, new Rectangle(edges[i], 1, edges[i + 1] - edges[i] - GAP, area.height - 2), i);
    }
  }

  private void chip(GC gc, Rectangle at, int index) {
    Severity severity = ALL.get(index);
    boolean on = shown.contains(severity);
    int count = counts.getOrDefault(severity, 0);
    if (on || index == hot) {
      gc.setBackground(theme.mix(Role.TEXT, Role.PANEL, index == hot ? HOT : GROUND));
      gc.fillRoundRectangle(at.x, at.y, at.width, at.height, CORNER, CORNER);
    }
    int x = at.x + INSET;
    if (Severities.dot(severity).isPresent()) {
      if (count > 0) {
        HealthDot.paint(gc, theme, Severities.dot(severity).get(), x + HealthDot.SIZE / 2, at.y + at.height / 2);
      }
      x += DOT;
    }
    gc.setFont(theme.font(Face.BODY));
    gc.setForeground(theme.color(on && count > 0 ? Role.TEXT : Role.DIM));
    Point word = gc.textExtent(Wording.word(severity));
    gc.drawText(Wording.word(severity), x, at.y + (at.height - word.y) / 2, true);
    if (!on) {
      gc.setLineWidth(1);
      gc.drawLine(x - 1, at.y + at.height / 2 + 1, x + word.x + 1, at.y + at.height / 2 + 1);
    }
    if (edges[ALL.size()] == full) {
      figures(gc, at, count(count));
    }
    focus(gc, at, index);
  }

  private void figures(GC gc, Rectangle at, String count) {
    gc.setFont(theme.font(Face.SMALL_FIGURES));
    Point size = gc.textExtent(count);
    gc.drawText(count, at.x + at.width - INSET - size.x, at.y + (at.height - size.y) / 2, true);
  }

  private void focus(GC gc, Rectangle at, int index) {
    if (index == marked && canvas.isFocusControl()) {
      gc.setForeground(theme.color(Role.ACCENT));
      gc.setLineWidth(1);
      gc.drawRoundRectangle(at.x, at.y, at.width - 1, at.height - 1, CORNER, CORNER);
    }
  }

  private int at(int x) {
    for (int i = 0; i < ALL.size(); i++) {
      if (x >= edges[i] && x < edges[i + 1] - GAP) {
        return i;
      }
    }
    return -1;
  }

  private void hover(int index) {
    if (index != hot) {
      hot = index;
      canvas.setToolTipText(
          index < 0 ? null : (shown.contains(ALL.get(index)) ? "Hide " : "Show ") + Wording.word(ALL.get(index)));
      canvas.redraw();
    }
  }

  private void released(Event event) {
    int index = at(event.x);
    if (event.button == 1 && index >= 0) {
      marked = index;
      toggled.accept(ALL.get(index));
    }
  }

  private void key(Event event) {
    switch (event.keyCode) {
      case SWT.ARROW_LEFT -> marked = Math.max(0, marked - 1);
      case SWT.ARROW_RIGHT -> marked = Math.min(ALL.size() - 1, marked + 1);
      case ' ', SWT.CR -> toggled.accept(ALL.get(marked));
      default -> {}
    }
    canvas.redraw();
  }
}
