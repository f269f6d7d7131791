package org.robotui.uic.plugins.internal.view;

import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.uic.plugins.internal.model.PluginLine;

/** A switch that is on, off, or on its way: its knob stands right, left, or between. Display thread. */
final class SwitchPaint {
  private static final int WIDTH = 32;
  private static final int HEIGHT = 16;
  private static final int KNOB = 10;
  private static final double FAINT = 0.45;

  private final Theme theme;

  SwitchPaint(Theme theme) {
    this.theme = theme;
  }

  void paint(GC gc, Rectangle cell, PluginLine line, boolean usable) {
    int x = cell.x + (cell.width - WIDTH) / 2;
    int y = cell.y + (cell.height - HEIGHT) / 2;
    boolean live = usable && (line.isSwitchable() || line.isTurning());
    gc.setAntialias(SWT.ON);
    if (line.isOn()) {
      gc.setBackground(live ? theme.color(Role.ACCENT) : theme.mix(Role.ACCENT, Role.PANEL, FAINT));
      gc.fillRoundRectangle(x, y, WIDTH, HEIGHT, HEIGHT, HEIGHT);
      gc.setBackground(theme.on(Role.ACCENT));
    } else {
      gc.setForeground(live ? theme.color(Role.DIM) : theme.mix(Role.DIM, Role.PANEL, FAINT));
      gc.setLineWidth(1);
      gc.drawRoundRectangle(x, y, WIDTH - 1, HEIGHT - 1, HEIGHT, HEIGHT);
      gc.setBackground(live ? theme.color(Role.DIM) : theme.mix(Role.DIM, Role.PANEL, FAINT));
    }
    int margin = (HEIGHT - KNOB) / 2;
    int knob = line.isTurning() ? (WIDTH - KNOB) / 2 : line.isOn() ? WIDTH - KNOB - margin : margin;
    gc.fillOval(x + knob, y + margin, KNOB, KNOB);
  }
}
