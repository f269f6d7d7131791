package org.robotui.uic.gps.internal.view;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.entity.gps.GeoPoint;
import org.robotui.entity.gps.GeoText;
import org.robotui.entity.gps.LocalPlane;
import org.robotui.entity.grid.ScaleBar;
import org.robotui.ui.Face;
import org.robotui.ui.Figures;
import org.robotui.ui.Role;
import org.robotui.ui.StateView;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;
import org.robotui.ui.scene.Viewport;
import org.robotui.uic.gps.internal.GpsOptions;
import org.robotui.uic.gps.internal.model.GpsSnapshot;
import org.robotui.uic.gps.internal.model.Receiver;

/** What lies over the plane and does not move with it. Display thread. */
final class GpsOverlay {
  private static final int PILL = 24;
  private static final int ROW = 18;
  private static final int ARROW = 24;
  private static final int ARROW_HALF = 6;
  private static final int MOST_RECEIVERS = 8;
  private static final int SCALE_ROOM = 160;
  private static final int BANNER_HALF = 90;

  private final Theme theme;
  private final StateView states;
  private List<Receiver> listed = List.of();
  private Rectangle list = new Rectangle(0, 0, 0, 0);

  GpsOverlay(Theme theme) {
    this.theme = theme;
    this.states = new StateView(theme);
  }

  void corners(GC gc, Viewport viewport, GpsSnapshot snapshot, GpsOptions options, Optional<Point> pointer) {
    ScaleBar.paint(gc, theme, viewport);
    north(gc, viewport.width() - 2 * Theme.EDGE, Theme.EDGE);
    snapshot.plane().ifPresent(plane -> coordinates(gc, viewport, plane, snapshot, options, pointer));
  }

  /** The receivers at the upper left: each with its colour, name, quality and accuracy. */
  void receivers(GC gc, Rectangle area, GpsSnapshot snapshot, GpsOptions options) {
    listed = snapshot.receivers().subList(0, Math.min(MOST_RECEIVERS, snapshot.receivers().size()));
    ReceiverRows rows = new ReceiverRows(gc, theme, snapshot.plane());
    int hidden = snapshot.receivers().size() - listed.size();
    int width = Math.min(area.width - 5 * Theme.EDGE, rows.width(listed));
    list = new Rectangle(Theme.EDGE, Theme.EDGE, width, (listed.size() + (hidden > 0 ? 1 : 0)) * ROW + 2 * Theme.STEP);
    states.pill(gc, list);
    gc.setClipping(list);
    for (int i = 0; i < listed.size(); i++) {
      boolean followed = options.follow() && snapshot.followed(options.followed()).equals(Optional.of(listed.get(i)));
      rows.paint(listed.get(i), list.x + 2 * Theme.STEP, list.y + Theme.STEP + i * ROW, ROW, followed);
    }
    if (hidden > 0) {
      rows.more(hidden, list.x + 2 * Theme.STEP, list.y + Theme.STEP + listed.size() * ROW, ROW);
    }
    gc.setClipping((Rectangle) null);
  }

  /** The receiver of the list at a point. */
  Optional<Receiver> receiverAt(int x, int y) {
    int row = Math.floorDiv(y - list.y - Theme.STEP, ROW);
    return list.contains(x, y) && row >= 0 && row < listed.size() ? Optional.of(listed.get(row)) : Optional.empty();
  }

  /** Where words in the middle of the upper edge do not lie on the list. */
  Rectangle free(Rectangle area) {
    int below = list.y + list.height + Theme.STEP - Theme.EDGE;
    return wide(area) ? area : new Rectangle(area.x, below, area.width, Math.max(1, area.height - below));
  }

  private boolean wide(Rectangle area) {
    return list.x + list.width + Theme.STEP < area.width / 2 - BANNER_HALF;
  }

  void hint(GC gc, Rectangle area, String text) {
    gc.setFont(theme.font(Face.SMALL));
    Point size = gc.textExtent(text);
    int width = size.x + 2 * Theme.EDGE;
    // Below the place where stale data say their age.
    int top = Math.max(2 * Theme.EDGE + PILL,
        wide(area) ? list.y + list.height + Theme.STEP : list.y + list.height + 2 * Theme.STEP + PILL);
    Rectangle pill = new Rectangle((area.width - width) / 2, top, width, PILL);
    states.pill(gc, pill);
    gc.setForeground(theme.color(Role.ACCENT));
    gc.drawText(text, pill.x + Theme.EDGE, pill.y + (PILL - size.y) / 2, true);
  }

  private void north(GC gc, int x, int y) {
    gc.setFont(theme.font(Face.SMALL_STRONG));
    gc.setForeground(theme.color(Role.DIM));
    gc.setBackground(theme.color(Role.DIM));
    gc.setAlpha(255);
    gc.fillPolygon(new int[]{x, y, x + ARROW_HALF, y + ARROW, x, y + ARROW - ARROW_HALF, x - ARROW_HALF, y + ARROW});
    Point size = gc.textExtent("N");
    gc.drawText("N", x - size.x / 2, y + ARROW + 2, true);
  }

  private void coordinates(
      GC gc, Viewport viewport, LocalPlane plane, GpsSnapshot snapshot, GpsOptions options, Optional<Point> pointer) {
    List<String> lines = new ArrayList<>();
    Optional<GeoPoint> pointed = pointer.flatMap(p -> plane.place(viewport.worldX(p.x), viewport.worldY(p.y)));
    if (pointed.isPresent()) {
      lines.add(words(pointed.get(), options));
      Point p = pointer.get();
      lines.add(metres(viewport.worldX(p.x), viewport.worldY(p.y)));
    } else {
      snapshot.followed(options.followed()).ifPresent(r -> of(r, options, lines));
    }
    if (!lines.isEmpty()) {
      paint(gc, viewport, lines);
    }
  }

  private static void of(Receiver receiver, GpsOptions options, List<String> lines) {
    receiver.place().ifPresent(p -> lines.add(words(p, options)));
    String altitude =
        Double.isFinite(receiver.fix().altitude()) ? "  alt " + Figures.of(receiver.fix().altitude(), 1, "m") : "";
    receiver.at().ifPresent(at -> lines.add(metres(at.east(), at.north()) + altitude));
  }

  private void paint(GC gc, Viewport viewport, List<String> lines) {
    gc.setFont(theme.font(Face.SMALL_FIGURES));
    int room = viewport.width() - SCALE_ROOM - 3 * Theme.EDGE;
    int width = Math.min(room, lines.stream().mapToInt(l -> gc.textExtent(l).x).max().orElse(0)) + 2 * Theme.EDGE;
    int height = lines.size() * ROW + 2 * Theme.STEP;
    Rectangle pill = new Rectangle(Theme.EDGE, viewport.height() - Theme.EDGE - height, width, height);
    states.pill(gc, pill);
    for (int i = 0; i < lines.size(); i++) {
      String text = TextFit.shorten(gc, lines.get(i), width - 2 * Theme.EDGE);
      gc.setForeground(theme.color(i == 0 ? Role.TEXT : Role.DIM));
      gc.drawText(text, pill.x + Theme.EDGE, pill.y + Theme.STEP + i * ROW + (ROW - gc.textExtent(text).y) / 2, true);
    }
  }

  private static String words(GeoPoint place, GpsOptions options) {
    return options.sexagesimal() ? GeoText.sexagesimal(place) : GeoText.decimal(place);
  }

  private static String metres(double east, double north) {
    return "E " + Figures.of(east, 2, "m") + "  N " + Figures.of(north, 2, "m");
  }
}
