package org.robotui.ui.control;

import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.HealthDot;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;

/** A line of words with a dot before them; all of them are the tooltip, since they may be cut. Display thread. */
public final class NoticeLine {
  private static final int HEIGHT = 24;

  private final PaintedCanvas canvas;
  private final Theme theme;
  private final Face face;
  private Health health = Health.NONE;
  private String words = "";

  /**
   * An empty line.
   *
   * @param parent the parent, with a grid layout
   * @param theme colours and fonts
   * @param face of the words
   */
  public NoticeLine(Composite parent, Theme theme, Face face) {
    this.theme = theme;
    this.face = face;
    canvas = new PaintedCanvas(parent, theme, this::paint);
    GridData data = new GridData(SWT.FILL, SWT.CENTER, true, false);
    data.heightHint = HEIGHT;
    data.widthHint = 0;
    canvas.setLayoutData(data);
  }

  /**
   * What stands in the layout.
   *
   * @return the control, with its place
   */
  public Control control() {
    return canvas;
  }

  /**
   * Says something else.
   *
   * @param dot what to think of it; no dot where it is {@link Health#NONE}
   * @param text the words, empty for none
   */
  public void show(Health dot, String text) {
    if (health != dot || !words.equals(text)) {
      health = dot;
      words = text;
      canvas.setToolTipText(text.isEmpty() ? null : text.replace("&", "&&"));
      canvas.redraw();
    }
  }

  /**
   * What it says.
   *
   * @return the words
   */
  public String words() {
    return words;
  }

  private void paint(GC gc, Rectangle area) {
    if (words.isEmpty()) {
      return;
    }
    int left = Theme.EDGE;
    if (health != Health.NONE) {
      HealthDot.paint(gc, theme, health, left + HealthDot.SIZE / 2, area.height / 2);
      left += HealthDot.SIZE + 2 * Theme.STEP;
    }
    gc.setFont(theme.font(face));
    gc.setForeground(theme.color(health == Health.OK ? Role.DIM : health.role()));
    String shown = TextFit.shorten(gc, words, area.width - left - Theme.STEP);
    gc.drawText(shown, left, (area.height - gc.textExtent(shown).y) / 2, true);
  }
}
