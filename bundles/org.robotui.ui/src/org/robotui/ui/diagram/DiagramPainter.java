package org.robotui.ui.diagram;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Color;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.graphics.Transform;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.HealthDot;
import org.robotui.ui.Role;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;
import org.robotui.ui.diagram.Wire.Corner;

/** Paints what is seen of a diagram; small letters are left out where they could not be read. Display thread. */
final class DiagramPainter {
  private static final int OPAQUE = 255;
  private static final int FADED = 110;
  private static final double TITLES_FROM = 0.3;
  private static final double NOTES_FROM = 0.5;
  /**
   * Labels of wires are read from here on: below the next number of a zoom they are as large as at that, as long as
   * they do not cover each other.
   */
  private static final double LABELS_FROM = 0.2;
  private static final double LABELS_READABLE = 0.85;
  private static final int CORNER = 8;
  private static final int PADDING = 10;
  private static final int LABEL_EDGE = 3;
  private static final double HEAD = 7;
  private static final double HEAD_WIDE = 3.5;

  private final Theme theme;
  private double zoom = 1;
  private double seenLeft;
  private double seenTop;
  private double seenRight;
  private double seenBottom;

  DiagramPainter(Theme theme) {
    this.theme = theme;
  }

  /** Paints; where something is selected, all but what is lit fades. */
  void paint(GC gc, Rectangle area, Diagram diagram, DiagramEye eye, Optional<Object> selected, Set<Object> lit) {
    zoom = eye.zoom();
    seenLeft = eye.diagramX(area.x);
    seenTop = eye.diagramY(area.y);
    seenRight = eye.diagramX(area.x + (double) area.width);
    seenBottom = eye.diagramY(area.y + (double) area.height);
    Transform transform = new Transform(gc.getDevice());
    transform.translate((float) eye.left(), (float) eye.top());
    transform.scale((float) zoom, (float) zoom);
    gc.setTransform(transform);
    boolean fades = !lit.isEmpty();
    diagram.boxes().stream().filter(box -> box.form() == Box.Form.GROUP && seen(box))
        .forEach(box -> group(gc, box, selected));
    List<Wire> wires = diagram.wires().stream().filter(this::seen).toList();
    wires.forEach(wire -> wire(gc, wire, fades, near(wire, selected, lit)));
    labels(gc, transform, wires, fades, wire -> near(wire, selected, lit));
    diagram.boxes().stream().filter(box -> box.form() != Box.Form.GROUP && seen(box)).forEach(box -> {
      gc.setAlpha(!fades || lit.contains(box.key()) ? OPAQUE : FADED);
      box(gc, box, selected.filter(box.key()::equals).isPresent(), lit.contains(box.key()));
    });
    gc.setAlpha(OPAQUE);
    gc.setTransform(null);
    transform.dispose();
  }

  private boolean seen(Box box) {
    return box.x() < seenRight && box.x() + box.width() > seenLeft && box.y() < seenBottom
        && box.y() + box.height() > seenTop;
  }

  private boolean seen(Wire wire) {
    double left = Double.POSITIVE_INFINITY;
    double right = Double.NEGATIVE_INFINITY;
    double top = Double.POSITIVE_INFINITY;
    double bottom = Double.NEGATIVE_INFINITY;
    for (Corner corner : wire.corners()) {
      left = Math.min(left, corner.x());
      right = Math.max(right, corner.x());
      top = Math.min(top, corner.y());
      bottom = Math.max(bottom, corner.y());
    }
    return left <= seenRight && right >= seenLeft && top <= seenBottom && bottom >= seenTop;
  }

  private void group(GC gc, Box box, Optional<Object> selected) {
    boolean chosen = selected.filter(box.key()::equals).isPresent();
    gc.setBackground(theme.mix(Role.LINE, Role.PANEL, 0.22));
    gc.fillRoundRectangle(round(box.x()), round(box.y()), round(box.width()), round(box.height()), CORNER, CORNER);
    line(gc, chosen ? theme.color(Role.ACCENT) : theme.mix(Role.LINE, Role.PANEL, 0.7), chosen ? 2 : 1);
    gc.drawRoundRectangle(round(box.x()), round(box.y()), round(box.width()), round(box.height()), CORNER, CORNER);
    if (zoom >= TITLES_FROM) {
      words(gc, box.title(), Face.SMALL_STRONG, Role.DIM, box.x() + PADDING, box.y() + 4, box.width() - 2 * PADDING);
    }
  }

  private void box(GC gc, Box box, boolean chosen, boolean lit) {
    int x = round(box.x());
    int y = round(box.y());
    int width = round(box.width());
    int height = round(box.height());
    int corner = box.form() == Box.Form.PILL ? height : CORNER;
    gc.setBackground(chosen ? theme.mix(Role.ACCENT, Role.PANEL, 0.25)
        : theme.mix(box.role(), Role.PANEL, box.role() == Role.LINE ? 0.45 : 0.14));
    gc.fillRoundRectangle(x, y, width, height, corner, corner);
    Color edge = chosen || lit ? theme.color(Role.ACCENT)
        : theme.mix(box.role(), Role.PANEL, box.role() == Role.LINE ? 1 : 0.75);
    line(gc, edge, chosen ? 2 : 1);
    gc.drawRoundRectangle(x, y, width, height, corner, corner);
    if (zoom >= TITLES_FROM) {
      words(gc, box);
    }
  }

  private void words(GC gc, Box box) {
    boolean noted = !box.note().isEmpty() && zoom >= NOTES_FROM;
    int lead = box.health() == Health.NONE ? 0 : HealthDot.SIZE + 6;
    double room = box.width() - 2 * PADDING - lead;
    gc.setFont(theme.font(Face.BODY));
    String title = TextFit.inTheMiddle(gc, box.title(), (int) Math.ceil(room));
    double left = box.x() + (box.width() - gc.textExtent(title).x - lead) / 2;
    double middle = box.y() + (noted ? box.height() * 0.34 : box.height() / 2);
    if (lead > 0) {
      HealthDot.paint(gc, theme, box.health(), round(left) + HealthDot.SIZE / 2, round(middle));
    }
    gc.setForeground(theme.color(Role.TEXT));
    gc.drawText(title, round(left + lead), round(middle - gc.textExtent(title).y / 2.0), true);
    if (noted) {
      gc.setFont(theme.font(Face.SMALL));
      String note = TextFit.shorten(gc, box.note(), round(box.width() - 2 * PADDING));
      gc.setForeground(
          theme.color(box.health() == Health.WARNING || box.health() == Health.BAD ? Role.TEXT : Role.DIM));
      gc.drawText(note, round(box.x() + (box.width() - gc.textExtent(note).x) / 2),
          round(box.y() + box.height() * 0.55), true);
    }
  }

  private void words(GC gc, String text, Face face, Role role, double x, double y, double room) {
    gc.setFont(theme.font(face));
    gc.setForeground(theme.color(role));
    gc.drawText(TextFit.shorten(gc, text, round(room)), round(x), round(y), true);
  }

  private static boolean near(Wire wire, Optional<Object> selected, Set<Object> lit) {
    return selected.filter(key -> wire.from().equals(key) || wire.to().equals(key)).isPresent()
        || selected.isEmpty() && lit.contains(wire.from()) && lit.contains(wire.to());
  }

  private void wire(GC gc, Wire wire, boolean fades, boolean near) {
    gc.setAlpha(!fades || near ? OPAQUE : FADED);
    line(gc, near ? theme.color(Role.ACCENT) : theme.mix(wire.role(), Role.PANEL, 0.8), near ? 2 : 1);
    gc.setLineStyle(wire.dashed() ? SWT.LINE_DASH : SWT.LINE_SOLID);
    gc.drawPolyline(points(wire.corners()));
    gc.setLineStyle(SWT.LINE_SOLID);
    head(gc, wire.corners());
  }

  private static int[] points(List<Corner> corners) {
    int[] points = new int[2 * corners.size()];
    for (int i = 0; i < corners.size(); i++) {
      points[2 * i] = round(corners.get(i).x());
      points[2 * i + 1] = round(corners.get(i).y());
    }
    return points;
  }

  private static void head(GC gc, List<Corner> corners) {
    Corner end = corners.getLast();
    Corner before = corners.get(corners.size() - 2);
    double length = Math.max(1e-9, Math.hypot(end.x() - before.x(), end.y() - before.y()));
    double dx = (end.x() - before.x()) / length;
    double dy = (end.y() - before.y()) / length;
    gc.setBackground(gc.getForeground());
    gc.fillPolygon(new int[]{round(end.x()), round(end.y()),
        round(end.x() - HEAD * dx + HEAD_WIDE * dy), round(end.y() - HEAD * dy - HEAD_WIDE * dx),
        round(end.x() - HEAD * dx - HEAD_WIDE * dy), round(end.y() - HEAD * dy + HEAD_WIDE * dx)});
  }

  /** Those of what is lit go first; one that would cover another is left out. */
  private void labels(GC gc, Transform eye, List<Wire> wires, boolean fades, Predicate<Wire> near) {
    if (zoom < LABELS_FROM) {
      return;
    }
    gc.setFont(theme.font(Face.SMALL));
    gc.setBackground(theme.color(Role.PANEL));
    gc.setForeground(theme.color(Role.TEXT));
    List<Rectangle> taken = new ArrayList<>();
    wires.stream().filter(wire -> !wire.label().isEmpty()).sorted(Comparator.comparing((Wire wire) -> !near.test(wire)))
        .forEach(wire -> {
          gc.setAlpha(!fades || near.test(wire) ? OPAQUE : FADED);
          label(gc, eye, wire, taken);
        });
    gc.setTransform(eye);
    gc.setAlpha(OPAQUE);
  }

  private void label(GC gc, Transform eye, Wire wire, List<Rectangle> taken) {
    double grown = Math.max(1, LABELS_READABLE / zoom);
    Point size = gc.textExtent(wire.label());
    Corner middle = wire.middle();
    Rectangle place =
        new Rectangle(round(middle.x() - grown * (size.x / 2.0 + LABEL_EDGE)), round(middle.y() - grown * size.y / 2.0),
            round(grown * (size.x + 2 * LABEL_EDGE)), round(grown * size.y));
    if (taken.stream().noneMatch(place::intersects)) {
      taken.add(place);
      float[] elements = new float[6];
      eye.getElements(elements);
      Transform there = new Transform(gc.getDevice(), elements);
      there.translate((float) middle.x(), (float) middle.y());
      there.scale((float) grown, (float) grown);
      gc.setTransform(there);
      gc.fillRoundRectangle(-size.x / 2 - LABEL_EDGE, -size.y / 2, size.x + 2 * LABEL_EDGE, size.y, CORNER, CORNER);
      gc.drawText(wire.label(), -size.x / 2, -size.y / 2, true);
      there.dispose();
    }
  }

  /** Lines stay as thick as they are on the screen, whatever the zoom, but not thicker than the boxes allow. */
  private void line(GC gc, Color color, int width) {
    gc.setForeground(color);
    gc.setLineWidth((int) Math.max(1, Math.round(width / Math.max(zoom, 0.5))));
  }

  private static int round(double value) {
    return (int) Math.round(value);
  }
}
