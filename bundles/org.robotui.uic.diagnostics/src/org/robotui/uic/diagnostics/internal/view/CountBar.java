package org.robotui.uic.diagnostics.internal.view;

import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.eclipse.swt.SWT;
import org.eclipse.swt.accessibility.AccessibleAdapter;
import org.eclipse.swt.accessibility.AccessibleEvent;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.HealthDot;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.uic.diagnostics.internal.model.Level;

/** How many parts are at each level, the worst first. Display thread. */
final class CountBar {
  static final int HEIGHT = 26;

  private static final List<Level> ALL = List.of(Level.ERROR, Level.STALE, Level.WARNING, Level.OK);
  private static final int DOT = HealthDot.SIZE + 6;
  private static final int FIGURES = 30;
  private static final int GAP = 8;

  private final PaintedCanvas canvas;
  private final Theme theme;
  private final int full;
  private Map<Level, Integer> counts = Map.of();

  CountBar(Composite parent, Theme theme) {
    this.theme = theme;
    canvas = new PaintedCanvas(parent, SWT.NO_FOCUS, theme, Role.PANEL, this::paint);
    full = measured();
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

  /** How wide it is with words. */
  int width() {
    return full;
  }

  private int measured() {
    GC gc = new GC(canvas);
    gc.setFont(theme.font(Face.BODY));
    int width = ALL.stream().mapToInt(level -> DOT + gc.textExtent(level.word()).x + FIGURES + GAP).sum();
    gc.dispose();
    return width;
  }

  void show(Map<Level, Integer> next) {
    if (!counts.equals(next)) {
      counts = next;
      canvas.setToolTipText(words());
      canvas.redraw();
    }
  }

  private void paint(GC gc, Rectangle area) {
    boolean words = area.width >= full;
    int x = area.x;
    for (Level level : ALL) {
      x = level(gc, area, x, level, words);
    }
  }

  /** Where there is no room for words, the shapes of the dots and the tooltip tell the levels apart. */
  private int level(GC gc, Rectangle area, int left, Level level, boolean words) {
    int count = counts.getOrDefault(level, 0);
    Health health = count == 0 ? Health.NONE : Levels.health(level);
    HealthDot.paint(gc, theme, health, left + HealthDot.SIZE / 2 + 1, area.y + area.height / 2);
    int x = left + DOT;
    gc.setForeground(theme.color(count == 0 ? Role.DIM : Role.TEXT));
    if (words) {
      gc.setFont(theme.font(Face.BODY));
      Point word = gc.textExtent(level.word());
      gc.drawText(level.word(), x, area.y + (area.height - word.y) / 2, true);
      x += word.x + 6;
    }
    gc.setFont(theme.font(Face.FIGURES));
    String figures = Integer.toString(count);
    gc.drawText(figures, x, area.y + (area.height - gc.textExtent(figures).y) / 2, true);
    return x + FIGURES - 6 + GAP;
  }

  private String words() {
    return ALL.stream().map(level -> counts.getOrDefault(level, 0) + " " + level.word())
        .collect(Collectors.joining(", "));
  }
}
