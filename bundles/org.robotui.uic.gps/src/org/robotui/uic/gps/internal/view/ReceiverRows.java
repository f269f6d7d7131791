package org.robotui.uic.gps.internal.view;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.robotui.api.port.InputState;
import org.robotui.entity.gps.FixLook;
import org.robotui.entity.gps.GeoText;
import org.robotui.entity.gps.Geodesic;
import org.robotui.entity.gps.LocalPlane;
import org.robotui.ui.Face;
import org.robotui.ui.Figures;
import org.robotui.ui.Icon;
import org.robotui.ui.Icons;
import org.robotui.ui.Role;
import org.robotui.ui.StateView;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;
import org.robotui.uic.gps.internal.model.Receiver;

/** Lines about receivers. Made for one paint; display thread. */
final class ReceiverRows {
  private static final int WIDEST_NAME = 240;
  private static final int SWATCH = 9;
  private static final int GAP = 10;
  private static final int MARK = 12;

  private final GC gc;
  private final Theme theme;
  private final Optional<LocalPlane> plane;
  private int nameWidth;
  private int wordWidth;

  ReceiverRows(GC gc, Theme theme, Optional<LocalPlane> plane) {
    this.gc = gc;
    this.theme = theme;
    this.plane = plane;
  }

  int width(List<Receiver> receivers) {
    gc.setFont(theme.font(Face.SMALL));
    int names = receivers.stream().mapToInt(r -> gc.textExtent(name(r)).x).max().orElse(0);
    int words = receivers.stream().mapToInt(r -> gc.textExtent(word(r)).x).max().orElse(0);
    int more = receivers.stream().mapToInt(r -> gc.textExtent(more(r)).x).max().orElse(0);
    nameWidth = names;
    wordWidth = words;
    return 4 * Theme.STEP + SWATCH + 2 * Theme.STEP + names + GAP + words + (more > 0 ? GAP + more : 0) + Theme.STEP
        + MARK;
  }

  void paint(Receiver receiver, int left, int top, int height, boolean followed) {
    gc.setFont(theme.font(Face.SMALL));
    int middle = top + height / 2;
    gc.setBackground(theme.traces().get(receiver.trace() % theme.traces().size()));
    gc.fillOval(left, middle - SWATCH / 2, SWATCH, SWATCH);
    int x = left + SWATCH + 2 * Theme.STEP;
    text(name(receiver), x, middle, Role.TEXT);
    x += nameWidth + GAP;
    text(word(receiver), x, middle, role(receiver));
    x += wordWidth + GAP;
    String more = more(receiver);
    text(more, x, middle, Role.DIM);
    if (followed) {
      gc.setForeground(theme.color(Role.ACCENT));
      int end = more.isEmpty() ? x - GAP : x + gc.textExtent(more).x;
      Icons.paint(gc, Icon.FOLLOW, end + 2 * Theme.STEP, middle - MARK / 2, MARK);
    }
  }

  void more(int hidden, int left, int top, int height) {
    gc.setFont(theme.font(Face.SMALL));
    text("and " + hidden + " more", left + SWATCH + 2 * Theme.STEP, top + height / 2, Role.DIM);
  }

  private void text(String text, int x, int middle, Role role) {
    gc.setForeground(theme.color(role));
    Point size = gc.textExtent(text);
    gc.drawText(text, x, middle - size.y / 2, true);
  }

  private String name(Receiver receiver) {
    return TextFit.shorten(gc, receiver.name(), WIDEST_NAME);
  }

  private static boolean live(Receiver receiver) {
    return receiver.state() instanceof InputState.Live;
  }

  private static String word(Receiver receiver) {
    return live(receiver) ? FixLook.word(receiver.fix().quality()) : StateView.word(receiver.state());
  }

  private static Role role(Receiver receiver) {
    return live(receiver) ? FixLook.role(receiver.fix().quality()) : StateView.health(receiver.state()).role();
  }

  private String more(Receiver receiver) {
    if (receiver.place().isPresent() && receiver.at().isEmpty() && plane.isPresent()) {
      double distance = Geodesic.between(plane.get().origin(), receiver.place().get()).distance();
      return GeoText.distance(distance) + " away, not drawn";
    }
    boolean known = receiver.fixed() && Double.isFinite(receiver.fix().horizontalAccuracy());
    return known ? "\u00b1" + Figures.of(receiver.fix().horizontalAccuracy(), 2, "m") : "";
  }
}
