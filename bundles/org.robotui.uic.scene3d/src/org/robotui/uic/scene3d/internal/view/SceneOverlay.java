package org.robotui.uic.scene3d.internal.view;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Color;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.Vector3;
import org.robotui.gl.render.Rendered;
import org.robotui.gl.shape.Properties;
import org.robotui.gl.shape.Rgba;
import org.robotui.ui.ColorBar;
import org.robotui.ui.ColorBars;
import org.robotui.ui.Face;
import org.robotui.ui.Figures;
import org.robotui.ui.Health;
import org.robotui.ui.HealthDot;
import org.robotui.ui.Role;
import org.robotui.ui.StateView;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;
import org.robotui.ui.display.DisplayRow;
import org.robotui.uic.scene3d.internal.camera.Lens;
import org.robotui.uic.scene3d.internal.model.Selection;
import org.robotui.uic.scene3d.internal.model.Stage;
import org.robotui.uic.scene3d.internal.render.FrameScheduler;

/** What is written over the picture: axes, frame, figures, names of robots, the selection. Display thread. */
final class SceneOverlay {
  private static final int GIZMO = 22;
  private static final int GIZMO_PLACE = 40;
  private static final int CARD_WIDTH = 260;
  private static final int LINE = 17;
  private static final int MOST_ENTRIES = 16;
  private static final int MOST_NOTES = 3;
  private static final double MILLION = 1e6;
  private static final double THOUSAND = 1e3;

  private final Theme theme;
  private final StateView states;
  private final ColorBars bars;

  /** What is painted over. */
  record Scene(Stage stage, Lens lens, Shot shot, String rate, boolean treeOpen) {}

  SceneOverlay(Theme theme, StateView states) {
    this.theme = theme;
    this.states = states;
    this.bars = new ColorBars(theme);
  }

  void paint(GC gc, Rectangle area, Scene scene) {
    robots(gc, scene);
    gizmo(gc, area, scene.lens().pose().rotation());
    corner(gc, area, scene);
    notes(gc, area, scene);
  }

  /** What colours mean, where there is room for it. */
  void colors(GC gc, Rectangle area, Stage stage) {
    bars.paint(gc, area, stage.colors().stream()
        .map(c -> new ColorBar(c.title(), c.unit(), c.low(), c.high(), c::shade)).toList());
  }

  /** The selection with its properties, at the upper right. */
  void card(GC gc, Rectangle area, Selection selection) {
    Properties properties = selection.properties();
    List<Properties.Entry> entries = new ArrayList<>(properties.entries());
    Vector3 at = selection.place();
    entries.add(new Properties.Entry("at",
        Figures.fixed(at.x(), 3) + "  " + Figures.fixed(at.y(), 3) + "  " + Figures.of(at.z(), 3, "m")));
    int shown = Math.min(entries.size(), MOST_ENTRIES);
    int width = Math.min(CARD_WIDTH, area.width - 2 * Theme.EDGE);
    Rectangle card = new Rectangle(area.x + area.width - width - Theme.EDGE, area.y + Theme.EDGE, width,
        (shown + 1) * LINE + 4 * Theme.STEP);
    states.pill(gc, card);
    int inner = width - 4 * Theme.STEP;
    int left = card.x + 2 * Theme.STEP;
    gc.setFont(theme.font(Face.BODY_STRONG));
    gc.setForeground(theme.color(Role.TEXT));
    gc.drawText(TextFit.shorten(gc, properties.title(), inner), left, card.y + Theme.STEP, true);
    gc.setFont(theme.font(Face.SMALL));
    for (int i = 0; i < shown; i++) {
      entry(gc, entries.get(i), left, card.y + 2 * Theme.STEP + (i + 1) * LINE, inner);
    }
  }

  /** What is left of the picture beside the card: words at its top go there, where there is room for them. */
  static Rectangle besideCard(Rectangle area) {
    int left = area.width - CARD_WIDTH - 2 * Theme.EDGE;
    return left < CARD_WIDTH ? area : new Rectangle(area.x, area.y, left, area.height);
  }

  private void entry(GC gc, Properties.Entry entry, int left, int top, int width) {
    gc.setForeground(theme.color(Role.DIM));
    String name = TextFit.shorten(gc, entry.name(), width / 2);
    gc.drawText(name, left, top, true);
    gc.setForeground(theme.color(Role.TEXT));
    String value = TextFit.shorten(gc, entry.value(), width - gc.textExtent(name).x - 2 * Theme.STEP);
    gc.drawText(value, left + width - gc.textExtent(value).x, top, true);
  }

  private void robots(GC gc, Scene scene) {
    if (scene.stage().robots().size() < 2) {
      return;
    }
    gc.setFont(theme.font(Face.SMALL_STRONG));
    for (Stage.Robot robot : scene.stage().robots()) {
      robot.fixedFromBase().flatMap(t -> scene.lens().spot(t.translation())).ifPresent(s -> name(gc, robot, s));
    }
  }

  private void name(GC gc, Stage.Robot robot, Lens.Spot spot) {
    Point size = gc.textExtent(robot.name());
    Rectangle pill = new Rectangle((int) spot.x() - size.x / 2 - 3 * Theme.STEP, (int) spot.y() + 3 * Theme.STEP,
        size.x + 6 * Theme.STEP, size.y + 2);
    states.pill(gc, pill);
    gc.setBackground(color(robot.color()));
    gc.fillOval(pill.x + Theme.STEP, pill.y + pill.height / 2 - 3, 7, 7);
    gc.setForeground(theme.color(Role.TEXT));
    gc.drawText(robot.name(), pill.x + 4 * Theme.STEP, pill.y + 1, true);
  }

  private void gizmo(GC gc, Rectangle area, Quaternion fixedFromEye) {
    int x = area.x + GIZMO_PLACE;
    int y = area.y + area.height - GIZMO_PLACE;
    List<Axis> axes =
        new ArrayList<>(List.of(axis("x", fixedFromEye, new Vector3(1, 0, 0), new Color(0xe5, 0x53, 0x4b)),
            axis("y", fixedFromEye, new Vector3(0, 1, 0), new Color(0x3f, 0xb6, 0x8b)),
            axis("z", fixedFromEye, new Vector3(0, 0, 1), new Color(0x4d, 0xa3, 0xff))));
    axes.sort(Comparator.comparingDouble((Axis a) -> a.seen().x()).reversed());
    gc.setAntialias(SWT.ON);
    gc.setFont(theme.font(Face.SMALL_STRONG));
    gc.setLineWidth(2);
    for (Axis axis : axes) {
      int endX = x - (int) Math.round(axis.seen().y() * GIZMO);
      int endY = y - (int) Math.round(axis.seen().z() * GIZMO);
      gc.setForeground(axis.color());
      gc.drawLine(x, y, endX, endY);
      Point size = gc.textExtent(axis.name());
      gc.drawText(axis.name(), endX - (int) Math.round(axis.seen().y() * 8) - size.x / 2,
          endY - (int) Math.round(axis.seen().z() * 8) - size.y / 2, true);
    }
    gc.setLineWidth(1);
  }

  private record Axis(String name, Vector3 seen, Color color) {}

  private static Axis axis(String name, Quaternion fixedFromEye, Vector3 direction, Color color) {
    return new Axis(name, fixedFromEye.inverse().rotate(direction), color);
  }

  private void corner(GC gc, Rectangle area, Scene scene) {
    Stage stage = scene.stage();
    List<String> words = new ArrayList<>();
    stage.fixed().ifPresent(f -> words.add(stage.robots().size() > 1 ? f.toString() : f.name()));
    words.add(scene.rate());
    Rendered.Figures figures = scene.shot().figures();
    if (figures.points() + figures.pointsLeftOut() > 0) {
      words.add(count(figures.points())
          + (figures.pointsLeftOut() > 0 ? " of " + count(figures.points() + figures.pointsLeftOut()) : "")
          + " points");
    }
    words.add(Figures.of(stage.bytes() / MILLION, 1, "MB"));
    if (stage.dropped() > 0) {
      words.add(stage.dropped() + " dropped");
    }
    gc.setFont(theme.font(Face.SMALL));
    String line = TextFit.shorten(gc, String.join("  \u00b7  ", words), area.width - 3 * GIZMO_PLACE);
    Point size = gc.textExtent(line);
    gc.setForeground(theme.color(Role.DIM));
    gc.drawText(line, area.x + area.width - size.x - Theme.EDGE, area.y + area.height - size.y - 2 * Theme.STEP, true);
  }

  /** What is not seen and why, where the list that says it is closed or nothing is seen at all. */
  private void notes(GC gc, Rectangle area, Scene scene) {
    Stage stage = scene.stage();
    List<Note> notes = new ArrayList<>();
    scene.shot().problems().stream().limit(1).forEach(p -> notes.add(new Note(Health.WARNING, p)));
    if (!scene.treeOpen() || stage.fed().isEmpty()) {
      stage.rows().stream().filter(r -> r.spec().shown() && r.health() != Health.OK).limit(MOST_NOTES)
          .map(SceneOverlay::note).forEach(notes::add);
    }
    if (notes.isEmpty() && stage.fed().isEmpty()) {
      notes.add(new Note(Health.NONE, "No data yet that a display can show."));
    }
    gc.setFont(theme.font(Face.SMALL));
    int top = area.y + Theme.EDGE;
    for (Note note : notes) {
      top += note(gc, area, note, top) + Theme.STEP;
    }
  }

  private record Note(Health health, String words) {}

  private static Note note(DisplayRow row) {
    return new Note(row.health(), row.name() + ": " + row.words());
  }

  private int note(GC gc, Rectangle area, Note note, int top) {
    String words = TextFit.shorten(gc, note.words(), area.width - 2 * Theme.EDGE - 7 * Theme.STEP);
    Point size = gc.textExtent(words);
    Rectangle pill = new Rectangle(area.x + Theme.EDGE, top, size.x + 7 * Theme.STEP, size.y + 2 * Theme.STEP);
    states.pill(gc, pill);
    HealthDot.paint(gc, theme, note.health(), pill.x + 3 * Theme.STEP, pill.y + pill.height / 2);
    gc.setForeground(theme.color(Role.TEXT));
    gc.drawText(words, pill.x + 5 * Theme.STEP, pill.y + Theme.STEP, true);
    return pill.height;
  }

  /** Pictures are made when something changes. */
  static String rate(FrameScheduler studio) {
    double rate = studio.rate();
    if (rate >= 1) {
      return Math.round(rate) + " frames/s";
    }
    return studio.prepares() ? "being prepared" : studio.waits() ? "being drawn" : "at rest";
  }

  private static String count(long points) {
    return points >= MILLION ? Figures.fixed(points / MILLION, 1) + " M"
        : points >= 10 * THOUSAND ? Math.round(points / THOUSAND) + " k" : Long.toString(points);
  }

  static Color color(Rgba rgba) {
    return new Color(Math.round(rgba.red() * 255), Math.round(rgba.green() * 255), Math.round(rgba.blue() * 255));
  }

  /** Where a place is seen. */
  static Optional<Point> point(Lens lens, Vector3 place) {
    return lens.spot(place).map(s -> new Point((int) Math.round(s.x()), (int) Math.round(s.y())));
  }
}
