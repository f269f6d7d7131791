package org.robotui.uic.camera.internal;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.graphics.Color;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.RGB;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.api.port.InputState;
import org.robotui.data.image.CameraInfo;
import org.robotui.entity.image.Picture;
import org.robotui.ui.Face;
import org.robotui.ui.Figures;
import org.robotui.ui.Role;
import org.robotui.ui.StateView;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;

/** Words over the picture. Display thread. */
final class Labels {
  private static final int PILL = 22;
  private static final int SWATCH = 10;
  private static final int ROW = 16;

  private final Theme theme;
  private final StateView states;

  Labels(Theme theme) {
    this.theme = theme;
    this.states = new StateView(theme);
  }

  /** Place, value, direction and colour of a pixel. */
  void pixel(GC gc, Rectangle area, Picture picture, Point pixel, Optional<CameraInfo> info) {
    RGB color = picture.color(pixel.x, pixel.y);
    String bearing = info.flatMap(i -> Bearing.of(i, pixel.x, pixel.y, picture.width(), picture.height()))
        .map(b -> "   " + b.text()).orElse("");
    String words = String.format("x %4d  y %4d   %s   #%02x%02x%02x%s",
        pixel.x, pixel.y, picture.values().at(pixel.x, pixel.y), color.red, color.green, color.blue, bearing);
    Rectangle pill = pill(gc, area, words, SWATCH + 2 * Theme.STEP);
    gc.setBackground(new Color(color));
    gc.fillRectangle(pill.x + 2 * Theme.STEP, pill.y + (PILL - SWATCH) / 2, SWATCH, SWATCH);
    gc.setForeground(theme.color(Role.LINE));
    gc.drawRectangle(pill.x + 2 * Theme.STEP, pill.y + (PILL - SWATCH) / 2, SWATCH, SWATCH);
  }

  /** A sentence. */
  void message(GC gc, Rectangle area, String words) {
    pill(gc, area, words, 0);
  }

  /** Size, encoding, rate, age and frame at the upper left. */
  void details(GC gc, Rectangle area, Shot.Shown shown, InputState state, double age) {
    Picture picture = shown.picture();
    String rate = state instanceof InputState.Live live ? Figures.rate(live.rateHz()) : Figures.UNKNOWN;
    List<String> lines = List.of(
        picture.width() + " \u00d7 " + picture.height() + "  " + picture.encoding(),
        "rate  " + rate,
        "age   " + Figures.age(age),
        "frame " + (shown.frame().isEmpty() ? Figures.UNKNOWN : shown.frame()));
    gc.setFont(theme.font(Face.SMALL_FIGURES));
    int width = lines.stream().mapToInt(l -> gc.textExtent(l).x).max().orElse(0) + 4 * Theme.STEP;
    Rectangle pill =
        new Rectangle(area.x + Theme.EDGE, area.y + Theme.EDGE, width, lines.size() * ROW + 2 * Theme.STEP);
    states.pill(gc, pill);
    for (int i = 0; i < lines.size(); i++) {
      gc.setForeground(theme.color(i == 0 ? Role.TEXT : Role.DIM));
      gc.drawText(lines.get(i), pill.x + 2 * Theme.STEP, pill.y + Theme.STEP + i * ROW, true);
    }
  }

  private Rectangle pill(GC gc, Rectangle area, String words, int lead) {
    gc.setFont(theme.font(Face.SMALL_FIGURES));
    String text = TextFit.shorten(gc, words, area.width - 2 * Theme.EDGE - lead - 4 * Theme.STEP);
    Point size = gc.textExtent(text);
    Rectangle pill = new Rectangle(
        area.x + Theme.EDGE, area.y + area.height - Theme.EDGE - PILL, size.x + lead + 4 * Theme.STEP, PILL);
    states.pill(gc, pill);
    gc.setForeground(theme.color(Role.TEXT));
    gc.drawText(text, pill.x + lead + 2 * Theme.STEP, pill.y + (PILL - size.y) / 2, true);
    return pill;
  }
}
