package org.robotui.ui.ask;

import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.HealthDot;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;

/**
 * One line of words: a dot where there is something to judge, strong words, and quiet ones behind them. Cut words are
 * in the hint.
 */
final class Caption {
  private static final int GAP = 8;

  private final Theme theme;
  private final Face face;
  private final PaintedCanvas canvas;
  private Optional<Health> health = Optional.empty();
  private String strong = "";
  private String quiet = "";

  Caption(Composite parent, Theme theme, Face face) {
    this.theme = theme;
    this.face = face;
    canvas = new PaintedCanvas(parent, SWT.NO_FOCUS, theme, Role.PANEL, this::paint);
  }

  Control control() {
    return canvas;
  }

  void say(Optional<Health> how, String first, String then) {
    if (!how.equals(health) || !first.equals(strong) || !then.equals(quiet)) {
      health = how;
      strong = first;
      quiet = then;
      canvas.setToolTipText((first + "\n" + then).strip());
      canvas.requestPaint();
    }
  }

  private void paint(GC gc, Rectangle area) {
    int x = area.x;
    if (health.isPresent()) {
      HealthDot.paint(gc, theme, health.get(), x + HealthDot.SIZE / 2, area.y + area.height / 2);
      x += HealthDot.SIZE + GAP;
    }
    gc.setFont(theme.font(face));
    gc.setForeground(theme.color(health.filter(h -> h == Health.BAD).isPresent() ? Role.BAD : Role.TEXT));
    x += draw(gc, area, x, strong) + GAP;
    gc.setFont(theme.font(Face.BODY));
    gc.setForeground(theme.color(Role.DIM));
    draw(gc, area, x, quiet);
  }

  private static int draw(GC gc, Rectangle area, int x, String words) {
    String fitting = TextFit.shorten(gc, words, Math.max(0, area.x + area.width - x));
    gc.drawText(fitting, x, area.y + (area.height - gc.getFontMetrics().getHeight()) / 2, true);
    return gc.textExtent(fitting).x;
  }
}
