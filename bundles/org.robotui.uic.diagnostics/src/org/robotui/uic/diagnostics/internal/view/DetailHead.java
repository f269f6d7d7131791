package org.robotui.uic.diagnostics.internal.view;

import java.util.ArrayList;
import java.util.List;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.ui.Face;
import org.robotui.ui.HealthDot;
import org.robotui.ui.Role;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;
import org.robotui.uic.diagnostics.internal.model.DiagnosticsDetail;
import org.robotui.uic.diagnostics.internal.model.Level;

/** Paints name, level, message, device and age of a part. Display thread. */
final class DetailHead {
  static final int HEIGHT = 70;

  private static final int LINE = 20;
  private static final int TOP = 6;

  private final Theme theme;

  DetailHead(Theme theme) {
    this.theme = theme;
  }

  void paint(GC gc, Rectangle area, DiagnosticsDetail detail) {
    int left = area.x + Theme.EDGE;
    HealthDot.paint(gc, theme, Levels.health(detail.level()), left + HealthDot.SIZE / 2, area.y + TOP + LINE / 2);
    int words = left + HealthDot.SIZE + 2 * Theme.STEP;
    int right = area.x + area.width - Theme.STEP;
    gc.setFont(theme.font(Face.BODY));
    int word = gc.textExtent(detail.level().word()).x;
    String name =
        line(gc, words, area.y + TOP, right - words - word - Theme.EDGE, detail.title(), Face.BODY_STRONG, Role.TEXT);
    int end = words + gc.textExtent(name).x + Theme.EDGE;
    Role ink = detail.level() == Level.OK ? Role.DIM : Levels.health(detail.level()).role();
    line(gc, end, area.y + TOP, right - end, detail.level().word(), Face.BODY, ink);
    line(gc, words, area.y + TOP + LINE, right - words, detail.message(), Face.BODY, Role.TEXT);
    line(gc, words, area.y + TOP + 2 * LINE, right - words, facts(detail), Face.SMALL, Role.DIM);
  }

  static String facts(DiagnosticsDetail detail) {
    List<String> facts = new ArrayList<>();
    if (!detail.hardware().isBlank()) {
      facts.add("hardware " + detail.hardware());
    }
    if (!detail.told().isBlank()) {
      facts.add(detail.told());
    }
    facts.add(detail.source());
    return String.join("  \u00b7  ", facts);
  }

  private String line(GC gc, int x, int y, int width, String text, Face face, Role role) {
    gc.setFont(theme.font(face));
    gc.setForeground(theme.color(role));
    String shown = TextFit.shorten(gc, text.replace('\n', ' '), Math.max(0, width));
    gc.drawText(shown, x, y + (LINE - gc.textExtent(shown).y) / 2, true);
    return shown;
  }
}
