package org.robotui.uic.log.internal.view;

import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Text;
import org.robotui.ui.Face;
import org.robotui.ui.HealthDot;
import org.robotui.ui.Icon;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.QuietButton;
import org.robotui.uic.log.internal.model.LogLine;
import org.robotui.uic.log.internal.model.Wording;

/** The selected entry whole. Display thread. */
final class LogDetailPane {
  private static final int HEAD = 30;

  private final Composite root;
  private final Theme theme;
  private final Wording wording;
  private final PaintedCanvas head;
  private final Text body;
  private Optional<LogLine> line = Optional.empty();

  LogDetailPane(Composite parent, Theme theme, Wording wording, Runnable copy, Runnable close) {
    this.theme = theme;
    this.wording = wording;
    root = Boxes.panel(parent, theme, 3);
    head = new PaintedCanvas(root, theme, this::paint);
    head.setLayoutData(Boxes.line(HEAD));
    new QuietButton(root, theme, copy).icon(Icon.COPY).hint("Copy this entry (Ctrl+C)");
    new QuietButton(root, theme, close).icon(Icon.CLOSE).hint("Close the details (Esc)");
    body = new Text(root, SWT.MULTI | SWT.WRAP | SWT.READ_ONLY | SWT.V_SCROLL);
    body.setFont(theme.font(Face.FIGURES));
    body.setBackground(theme.color(Role.PANEL));
    body.setForeground(theme.color(Role.TEXT));
    GridData rest = new GridData(SWT.FILL, SWT.FILL, true, true, 3, 1);
    rest.horizontalIndent = Theme.EDGE - 2;
    body.setLayoutData(rest);
    body.addListener(SWT.KeyDown, e -> {
      if (e.keyCode == SWT.ESC) {
        close.run();
      }
    });
  }

  Control control() {
    return root;
  }

  /** Shows an entry; the same again only repaints its head, so that a selection in the text stays. */
  void show(LogLine next) {
    boolean other = line.filter(old -> old.id() == next.id()).isEmpty();
    line = Optional.of(next);
    if (other) {
      body.setText(Wording.whole(next.last()));
    }
    head.redraw();
  }

  void nothing() {
    line = Optional.empty();
  }

  private void paint(GC gc, Rectangle area) {
    gc.setForeground(theme.color(Role.LINE));
    gc.setLineWidth(1);
    gc.drawLine(area.x, area.y, area.x + area.width, area.y);
    line.ifPresent(l -> paint(gc, area, l));
  }

  private void paint(GC gc, Rectangle area, LogLine shown) {
    int[] x = {area.x + Theme.EDGE};
    int middle = area.y + area.height / 2 + 1;
    Severities.dot(shown.last().severity()).ifPresent(health -> {
      HealthDot.paint(gc, theme, health, x[0] + HealthDot.SIZE / 2, middle);
      x[0] += HealthDot.SIZE + 2 * Theme.STEP;
    });
    word(gc, area, x, Wording.word(shown.last().severity()), Face.BODY_STRONG,
        Severities.role(shown.last().severity()));
    word(gc, area, x, wording.date(shown.last()), Face.FIGURES, Role.DIM);
    word(gc, area, x, shown.last().origin(), Face.BODY_STRONG, Role.TEXT);
    if (shown.count() > 1) {
      word(gc, area, x, shown.count() + " times since " + wording.time(shown.first()), Face.BODY, Role.TEXT);
    }
    word(gc, area, x, shown.last().location(), Face.BODY, Role.DIM);
  }

  private void word(GC gc, Rectangle area, int[] x, String text, Face face, Role role) {
    gc.setFont(theme.font(face));
    gc.setForeground(theme.color(role));
    String fitting = TextFit.shorten(gc, text, Math.max(0, area.x + area.width - x[0]));
    gc.drawText(fitting, x[0], area.y + (area.height - gc.textExtent(text).y) / 2 + 1, true);
    x[0] += gc.textExtent(fitting).x + Theme.EDGE;
  }
}
