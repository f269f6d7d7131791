package org.robotui.ui.control;

import java.util.function.DoubleConsumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.accessibility.ACC;
import org.eclipse.swt.accessibility.AccessibleControlAdapter;
import org.eclipse.swt.accessibility.AccessibleControlEvent;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Canvas;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Event;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;

/**
 * A bar to set a limit: drag, click, wheel, or the arrow keys, Home and End. Display thread only.
 */
public final class LimitBar extends Canvas {
  private static final int HEIGHT = 20;
  private static final int WIDTH = 200;
  private static final int THICKNESS = 10;
  private static final double KEY_SHARE = 0.05;

  private final Theme theme;
  private final DoubleConsumer chosen;
  private final double max;
  private double value;
  private double seen = Double.NaN;

  /**
   * A bar from 0 to a maximum.
   *
   * @param parent the parent
   * @param theme colours
   * @param max the value at the right end, positive
   * @param chosen is given the value that the user sets
   */
  public LimitBar(Composite parent, Theme theme, double max, DoubleConsumer chosen) {
    super(parent, SWT.DOUBLE_BUFFERED);
    if (!(max > 0)) {
      throw new IllegalArgumentException("the maximum of a bar must be positive, is " + max);
    }
    this.theme = theme;
    this.max = max;
    this.chosen = chosen;
    setBackground(parent.getBackground());
    addPaintListener(e -> paint(e.gc, getClientArea()));
    listen();
    getAccessible().addAccessibleControlListener(new AccessibleControlAdapter() {
      @Override
      public void getRole(AccessibleControlEvent e) {
        e.detail = ACC.ROLE_SLIDER;
      }

      @Override
      public void getValue(AccessibleControlEvent e) {
        e.result = Double.toString(value);
      }
    });
  }

  /**
   * Shows a value; nobody is told.
   *
   * @param shown 0 to the maximum, else the nearest
   */
  public void value(double shown) {
    double next = Math.clamp(shown, 0.0, max);
    if (next != value) {
      value = next;
      redraw();
    }
  }

  /**
   * The value shown.
   *
   * @return 0 to the maximum
   */
  public double value() {
    return value;
  }

  /**
   * Marks how much of the limit is in use, as a thin line.
   *
   * @param used 0 to the maximum; NaN for no mark
   */
  public void mark(double used) {
    if (Double.compare(used, seen) != 0) {
      seen = used;
      redraw();
    }
  }

  @Override
  public Point computeSize(int widthHint, int heightHint, boolean changed) {
    checkWidget();
    return new Point(
        widthHint == SWT.DEFAULT ? WIDTH : widthHint, heightHint == SWT.DEFAULT ? HEIGHT : heightHint);
  }

  private void paint(GC gc, Rectangle area) {
    int top = (area.height - THICKNESS) / 2;
    gc.setAntialias(SWT.ON);
    gc.setBackground(theme.dark() ? theme.color(Role.GROUND) : theme.color(Role.LINE));
    gc.fillRoundRectangle(0, top, area.width, THICKNESS, THICKNESS, THICKNESS);
    int filled = (int) Math.round(area.width * value / max);
    gc.setBackground(isEnabled() ? theme.color(Role.ACCENT) : theme.color(Role.DIM));
    if (filled > 0) {
      gc.setClipping(0, top, filled, THICKNESS);
      gc.fillRoundRectangle(0, top, area.width, THICKNESS, THICKNESS, THICKNESS);
      gc.setClipping((Rectangle) null);
    }
    if (!Double.isNaN(seen)) {
      int x = (int) Math.round((area.width - 2) * Math.clamp(seen / max, 0.0, 1.0));
      gc.setBackground(theme.color(Role.TEXT));
      gc.fillRectangle(x, top - 2, 2, THICKNESS + 4);
    }
    if (isFocusControl()) {
      gc.setForeground(theme.color(Role.TEXT));
      gc.drawRoundRectangle(0, top - 1, area.width - 1, THICKNESS + 1, THICKNESS, THICKNESS);
    }
  }

  private void listen() {
    addListener(SWT.MouseDown, e -> drag(e, e.button == 1));
    addListener(SWT.MouseMove, e -> drag(e, (e.stateMask & SWT.BUTTON1) != 0));
    addListener(SWT.MouseVerticalWheel, e -> choose(value + Integer.signum(e.count) * max * KEY_SHARE));
    addListener(SWT.KeyDown, this::key);
    addListener(SWT.FocusIn, e -> redraw());
    addListener(SWT.FocusOut, e -> redraw());
    addListener(SWT.Traverse, e -> e.doit = e.detail == SWT.TRAVERSE_TAB_NEXT || e.detail == SWT.TRAVERSE_TAB_PREVIOUS);
  }

  private void drag(Event event, boolean held) {
    if (held) {
      setFocus();
      choose(max * event.x / Math.max(1, getClientArea().width));
    }
  }

  private void key(Event event) {
    switch (event.keyCode) {
      case SWT.ARROW_LEFT, SWT.ARROW_DOWN -> choose(value - max * KEY_SHARE);
      case SWT.ARROW_RIGHT, SWT.ARROW_UP -> choose(value + max * KEY_SHARE);
      case SWT.HOME -> choose(0);
      case SWT.END -> choose(max);
      default -> {}
    }
  }

  private void choose(double wanted) {
    double before = value;
    value(wanted);
    if (value != before) {
      chosen.accept(value);
    }
  }
}
