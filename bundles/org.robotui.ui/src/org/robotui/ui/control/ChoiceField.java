package org.robotui.ui.control;

import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.robotui.ui.Face;
import org.robotui.ui.Icon;
import org.robotui.ui.Icons;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.SpaceKey;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;

/** A field that opens a list of choices: by a click, Space, Enter or the arrow down. Display thread. */
public final class ChoiceField {
  private static final int CORNER = 6;
  private static final int ICON = 12;

  private final PaintedCanvas canvas;
  private final Theme theme;
  private final Runnable opened;
  private String words = "";

  /**
   * An empty field.
   *
   * @param parent the parent
   * @param theme colours and fonts
   * @param name for screen readers
   * @param opened shows the choices, for example in a {@link PopupMenu}
   */
  public ChoiceField(Composite parent, Theme theme, String name, Runnable opened) {
    this.theme = theme;
    this.opened = opened;
    canvas = new PaintedCanvas(parent, theme, this::paint);
    SpaceKey.claim(canvas);
    canvas.addListener(SWT.MouseDown, e -> {
      canvas.setFocus();
      opened.run();
    });
    canvas.addListener(SWT.KeyDown, this::key);
    canvas.addListener(SWT.FocusIn, e -> canvas.redraw());
    canvas.addListener(SWT.FocusOut, e -> canvas.redraw());
    canvas.addListener(SWT.Traverse,
        e -> e.doit = e.detail == SWT.TRAVERSE_TAB_NEXT || e.detail == SWT.TRAVERSE_TAB_PREVIOUS);
    Spoken.choice(canvas, name, () -> words);
  }

  /**
   * What stands in the layout.
   *
   * @return the control
   */
  public Control control() {
    return canvas;
  }

  /**
   * Shows what is chosen.
   *
   * @param text its words
   */
  public void show(String text) {
    if (!words.equals(text)) {
      words = text;
      canvas.redraw();
    }
  }

  private void key(Event event) {
    if (event.character == ' ' || event.keyCode == SWT.CR || event.keyCode == SWT.ARROW_DOWN) {
      opened.run();
    }
  }

  private void paint(GC gc, Rectangle area) {
    gc.setBackground(theme.color(Role.GROUND));
    gc.fillRoundRectangle(0, 0, area.width - 1, area.height - 1, CORNER, CORNER);
    if (canvas.isFocusControl()) {
      gc.setForeground(theme.color(Role.ACCENT));
      gc.setLineWidth(1);
      gc.drawRoundRectangle(0, 0, area.width - 1, area.height - 1, CORNER, CORNER);
    }
    gc.setForeground(theme.color(Role.DIM));
    Icons.paint(gc, Icon.OPEN, area.width - ICON - Theme.STEP, (area.height - ICON) / 2, ICON);
    gc.setFont(theme.font(Face.BODY));
    gc.setForeground(theme.color(Role.TEXT));
    String shown = TextFit.shorten(gc, words, area.width - ICON - 3 * Theme.STEP);
    gc.drawText(shown, Theme.STEP, (area.height - gc.textExtent("X").y) / 2, true);
  }
}
