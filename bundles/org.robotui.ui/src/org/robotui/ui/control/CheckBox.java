package org.robotui.ui.control;

import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.robotui.ui.Icon;
import org.robotui.ui.Icons;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.SpaceKey;
import org.robotui.ui.Theme;

/** A box with a check: a click or Space switches it. Display thread. */
public final class CheckBox {
  /** As high as it is best, in points. */
  public static final int HEIGHT = 24;

  private static final int BOX = 17;
  private static final int CORNER = 6;

  private final PaintedCanvas canvas;
  private final Theme theme;
  private final Runnable flipped;
  private boolean on;

  /**
   * A box that is not checked.
   *
   * @param parent the parent
   * @param theme colours
   * @param name for screen readers
   * @param flipped is told that the user wants it the other way; {@link #show} makes it so
   */
  public CheckBox(Composite parent, Theme theme, String name, Runnable flipped) {
    this.theme = theme;
    this.flipped = flipped;
    canvas = new PaintedCanvas(parent, theme, this::paint);
    SpaceKey.claim(canvas);
    canvas.addListener(SWT.MouseUp, this::released);
    canvas.addListener(SWT.KeyDown, this::key);
    canvas.addListener(SWT.FocusIn, e -> canvas.redraw());
    canvas.addListener(SWT.FocusOut, e -> canvas.redraw());
    canvas.addListener(SWT.Traverse, e -> e.doit = true);
    Spoken.box(canvas, name, () -> on);
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
   * Shows how it is.
   *
   * @param checked whether it is on
   */
  public void show(boolean checked) {
    if (on != checked) {
      on = checked;
      canvas.redraw();
    }
  }

  private void released(Event event) {
    if (event.button == 1 && canvas.getClientArea().contains(event.x, event.y)) {
      canvas.setFocus();
      flipped.run();
    }
  }

  private void key(Event event) {
    if (event.character == ' ') {
      flipped.run();
    }
  }

  private void paint(GC gc, Rectangle area) {
    int y = (area.height - BOX) / 2;
    gc.setBackground(theme.color(on ? Role.ACCENT : Role.GROUND));
    gc.fillRoundRectangle(0, y, BOX, BOX, CORNER, CORNER);
    gc.setForeground(theme.color(canvas.isFocusControl() ? Role.TEXT : on ? Role.ACCENT : Role.LINE));
    gc.setLineWidth(1);
    gc.drawRoundRectangle(0, y, BOX, BOX, CORNER, CORNER);
    if (on) {
      gc.setForeground(theme.on(Role.ACCENT));
      Icons.paint(gc, Icon.CHECK, 2, y + 2, BOX - 3);
    }
  }
}
