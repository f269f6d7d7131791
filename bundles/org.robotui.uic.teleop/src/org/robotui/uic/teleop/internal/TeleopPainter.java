package org.robotui.uic.teleop.internal;

import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.api.port.InputState;
import org.robotui.ui.Face;
import org.robotui.ui.Figures;
import org.robotui.ui.Health;
import org.robotui.ui.HealthDot;
import org.robotui.ui.Role;
import org.robotui.ui.StateView;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;

/** Paints stick, figures and the sentence at the bottom. Display thread. */
final class TeleopPainter {
  static final int BAR_HEIGHT = 20;

  private static final int LABEL = 80;
  private static final int NUMBERS = 61;
  private static final int NUMBER = 52;
  private static final int ROOM_FOR_MEASURED = 250;
  /** The knob is drawn around its point, so that the disc needs as much room around it. */
  static final double KNOB_SHARE = 0.2;
  private static final int OPAQUE = 255;
  private static final int FADED = 90;

  private final Theme theme;
  private final StateView states;

  TeleopPainter(Theme theme) {
    this.theme = theme;
    this.states = new StateView(theme);
  }

  void paint(GC gc, TeleopLayout at, TeleopViewState look, boolean focused) {
    if (StateView.showsContent(look.output())) {
      gc.setAlpha(drivable(look) ? OPAQUE : FADED);
      disc(gc, at.stick(), focused);
      measured(gc, at.stick(), look);
      knob(gc, at.stick(), look);
      gc.setAlpha(StateView.contentAlpha(look.output()));
      figures(gc, at, look, focused);
      gc.setAlpha(OPAQUE);
      states.paint(gc, at.stick(), look.output());
    } else {
      reason(gc, new Rectangle(0, 0, at.footer().width, at.footer().y), look.output());
    }
  }

  void footer(GC gc, Rectangle area, TeleopFooter footer, int room) {
    gc.setForeground(theme.color(Role.LINE));
    gc.setLineWidth(1);
    gc.drawLine(area.x, area.y, area.x + area.width, area.y);
    int middle = area.y + area.height / 2;
    HealthDot.paint(gc, theme, footer.health(), area.x + Theme.EDGE + HealthDot.SIZE / 2, middle);
    int left = area.x + Theme.EDGE + HealthDot.SIZE + 2 * Theme.STEP;
    gc.setForeground(theme.color(Role.TEXT));
    gc.setFont(theme.font(Face.BODY));
    int width = room - left;
    String text = TextFit.shorten(gc, footer.fitting(words -> gc.textExtent(words).x <= width), width);
    gc.drawText(text, left, middle - gc.textExtent(text).y / 2, true);
  }

  /** Why there is nothing to drive: what gives commands does not wait for data. */
  private void reason(GC gc, Rectangle area, InputState output) {
    if (output instanceof InputState.Waiting) {
      states.message(gc, area, Health.WAITING, "No link", output.explanation());
    } else {
      states.paint(gc, area, output);
    }
  }

  private static boolean drivable(TeleopViewState look) {
    return look.stoppedBy().isEmpty() && !(look.lease() instanceof TeleopViewState.Lease.Other)
        && StateView.contentAlpha(look.output()) == OPAQUE;
  }

  private void disc(GC gc, Rectangle disc, boolean focused) {
    gc.setAntialias(SWT.ON);
    gc.setBackground(theme.color(Role.GROUND));
    gc.fillOval(disc.x, disc.y, disc.width, disc.height);
    gc.setForeground(theme.color(Role.LINE));
    gc.setLineWidth(1);
    int x = disc.x + disc.width / 2;
    int y = disc.y + disc.height / 2;
    gc.drawLine(x, disc.y, x, disc.y + disc.height);
    gc.drawLine(disc.x, y, disc.x + disc.width, y);
    gc.drawOval(disc.x + disc.width / 4, disc.y + disc.height / 4, disc.width / 2, disc.height / 2);
    gc.setForeground(focused ? theme.color(Role.ACCENT) : theme.mix(Role.DIM, Role.LINE, 0.3));
    gc.drawOval(disc.x, disc.y, disc.width - 1, disc.height - 1);
  }

  private void knob(GC gc, Rectangle disc, TeleopViewState look) {
    Point centre = new Point(disc.x + disc.width / 2, disc.y + disc.height / 2);
    Point at = place(disc, onDisc(look.stick()));
    int size = Math.max(12, (int) (disc.width * KNOB_SHARE));
    if (!look.held()) {
      gc.setForeground(theme.color(Role.DIM));
      gc.setBackground(theme.color(Role.TITLE));
      gc.fillOval(at.x - size / 2, at.y - size / 2, size, size);
      gc.setLineWidth(2);
      gc.drawOval(at.x - size / 2, at.y - size / 2, size, size);
      return;
    }
    gc.setForeground(theme.color(Role.ACCENT));
    gc.setBackground(theme.color(Role.ACCENT));
    gc.setLineWidth(3);
    gc.drawLine(centre.x, centre.y, at.x, at.y);
    gc.fillOval(at.x - size / 2, at.y - size / 2, size, size);
  }

  private void measured(GC gc, Rectangle disc, TeleopViewState look) {
    look.measured().filter(speed -> look.limits().linear() > 0 && look.limits().angular() > 0).ifPresent(speed -> {
      Stick stick = onDisc(new Stick(speed.forward() / look.limits().linear(), speed.turn() / look.limits().angular()));
      Point at = place(disc, stick);
      gc.setForeground(theme.color(Role.GOOD));
      gc.setLineWidth(2);
      gc.drawOval(at.x - 4, at.y - 4, 8, 8);
    });
  }

  private void figures(GC gc, TeleopLayout at, TeleopViewState look, boolean focused) {
    if (at.rows() >= 2) {
      speed(gc, at.row(0), "linear", look.commanded().forward(), look.measured().map(Speed::forward).orElse(Double.NaN),
          "m/s");
      speed(gc, at.row(1), "angular", look.commanded().turn(), look.measured().map(Speed::turn).orElse(Double.NaN),
          "rad/s");
    }
    if (at.rows() == 4) {
      words(gc, at.row(2), "keys",
          fitting(gc, at.row(2), focused ? "W A S D, space = stop" : "click, then W A S D", "W A S D"),
          focused ? Role.TEXT : Role.DIM);
      words(gc, at.row(3), "dead-man", look.held() ? "held" : fitting(gc, at.row(3), "hold mouse or key", "hold"),
          look.held() ? Role.ACCENT : Role.TEXT);
    }
    if (at.bars() > 0) {
      barLabel(gc, at.bar(0), "speed limit " + Figures.of(look.limits().linear(), 2, "m/s"));
      barLabel(gc, at.bar(1), "turn limit " + Figures.of(look.limits().angular(), 2, "rad/s"));
    }
  }

  private void speed(GC gc, Rectangle row, String label, double value, double measured, String unit) {
    words(gc, row, label, "", Role.TEXT);
    gc.setFont(theme.font(Face.LARGE_FIGURES));
    gc.setForeground(theme.color(Role.TEXT));
    String number = Figures.fixed(value, 2);
    Point size = gc.textExtent(number);
    int top = row.y + (row.height - size.y) / 2;
    gc.drawText(number, row.x + NUMBERS + NUMBER - size.x, top, true);
    gc.drawText(unit, row.x + NUMBERS + NUMBER + 2 * Theme.STEP, top, true);
    if (row.width >= ROOM_FOR_MEASURED) {
      gc.setFont(theme.font(Face.SMALL_FIGURES));
      gc.setForeground(theme.color(Double.isNaN(measured) ? Role.DIM : Role.GOOD));
      String text = "is " + Figures.fixed(measured, 2);
      Point extent = gc.textExtent(text);
      gc.drawText(text, row.x + row.width - extent.x, row.y + (row.height - extent.y) / 2, true);
    }
  }

  /** What matters least is left out where it is narrow. */
  private String fitting(GC gc, Rectangle row, String whole, String least) {
    gc.setFont(theme.font(Face.BODY));
    return gc.textExtent(whole).x <= row.width - LABEL ? whole : least;
  }

  private void words(GC gc, Rectangle row, String label, String text, Role role) {
    gc.setFont(theme.font(Face.BODY));
    int top = row.y + (row.height - gc.textExtent(label).y) / 2;
    gc.setForeground(theme.color(Role.DIM));
    gc.drawText(label, row.x, top, true);
    gc.setForeground(theme.color(role));
    gc.drawText(TextFit.shorten(gc, text, row.width - LABEL), row.x + LABEL, top, true);
  }

  private void barLabel(GC gc, Rectangle bar, String text) {
    gc.setFont(theme.font(Face.SMALL));
    gc.setForeground(theme.color(Role.DIM));
    gc.drawText(text, bar.x, bar.y + BAR_HEIGHT + Theme.STEP / 2, true);
  }

  private static Stick onDisc(Stick stick) {
    return Stick.ofPointer(-stick.left(), -stick.forward());
  }

  private static Point place(Rectangle disc, Stick stick) {
    int radius = disc.width / 2;
    return new Point((int) Math.round(disc.x + radius - stick.left() * radius),
        (int) Math.round(disc.y + radius - stick.forward() * radius));
  }
}
