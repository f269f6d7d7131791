package org.robotui.entity.robot.internal.layer;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.robotui.api.port.Envelope;
import org.robotui.data.geometry.Footprint;
import org.robotui.entity.robot.Body;
import org.robotui.entity.robot.RobotEntity;
import org.robotui.geometry.Vector3;
import org.robotui.ui.Figures;
import org.robotui.ui.layer.DataLayer;
import org.robotui.ui.layer.LayerResult;
import org.robotui.ui.layer.LayerStatus;
import org.robotui.ui.layer.LayerTick;
import org.robotui.ui.layer.SeenRobot;
import org.robotui.ui.scene.Bounds;
import org.robotui.ui.scene.Description;
import org.robotui.ui.scene.Painter;
import org.robotui.ui.scene.Placer;

/** The bodies of all robots that the map has found; those whose outline came have it. */
final class RobotLayer implements DataLayer {
  private static final double LEAST_RADIUS = 0.01;
  private static final double FADED = 0.35;

  private final Map<String, Envelope<Footprint>> outlines = new LinkedHashMap<>();
  private List<Object> basis = List.of();
  private volatile List<Shown> shown = List.of();

  /** A body, and whether what says where it is has become old. */
  private record Shown(RobotEntity entity, boolean stale) {}

  @Override
  public LayerResult update(LayerTick tick) {
    tick.arrived().forEach(e -> {
      if (e.value() instanceof Footprint footprint
          && (outlines.size() < Footprints.MOST || outlines.containsKey(footprint.frame().robot()))) {
        @SuppressWarnings("unchecked") // the value is a footprint, and an envelope only gives it out
        Envelope<Footprint> taken = (Envelope<Footprint>) e;
        outlines.put(footprint.frame().robot(), taken);
      }
    });
    List<Object> next = new ArrayList<>(List.of(tick.robots(), tick.entry(), tick.placer().map(Placer::fixed)));
    List<Body> bodies = tick.robots().stream().map(robot -> body(robot, tick)).toList();
    next.add(bodies);
    boolean changed = !next.equals(basis);
    if (changed) {
      basis = next;
      shown = Stream.iterate(0, i -> i < bodies.size(), i -> i + 1)
          .map(i -> shown(tick.robots().get(i), bodies.get(i), bodies.size() > 1)).toList();
    }
    return new LayerResult(changed, new LayerStatus.Shown(bodies.size() + (bodies.size() == 1 ? " robot" : " robots")));
  }

  private static Shown shown(SeenRobot robot, Body body, boolean named) {
    RobotEntity entity = new RobotEntity(robot.number());
    entity.showName(named);
    entity.select(robot.selected());
    entity.prepare(body);
    return new Shown(entity, robot.stale());
  }

  private Body body(SeenRobot robot, LayerTick tick) {
    Optional<List<Vector3>> outline = Optional.ofNullable(outlines.get(robot.name()))
        .flatMap(e -> tick.placer().flatMap(p -> Footprints.place(p, e)));
    double radius = outline.map(corners -> radius(corners, robot.at())).orElse(tick.settings().number("radius"));
    return new Body(robot.name(), robot.fixedFromBase(), radius, outline, words(robot));
  }

  private static double radius(List<Vector3> corners, Vector3 at) {
    return Math.max(LEAST_RADIUS,
        corners.stream().mapToDouble(c -> Math.hypot(c.x() - at.x(), c.y() - at.y())).max().orElse(0));
  }

  private static String words(SeenRobot robot) {
    return "x " + Figures.fixed(robot.at().x(), 2) + "  y " + Figures.of(robot.at().y(), 2, "m") + "  "
        + Figures.degrees(robot.fixedFromBase().rotation().yaw(), 1);
  }

  @Override
  public void paint(Painter painter) {
    for (Shown body : shown) {
      painter.fade(body.stale() ? FADED : 1);
      body.entity().paint(painter);
      painter.fade(1);
    }
  }

  @Override
  public Optional<Bounds> bounds() {
    return shown.stream().flatMap(body -> body.entity().bounds().stream()).reduce(Bounds::union);
  }

  @Override
  public Optional<Description> describeAt(double x, double y, double tolerance) {
    return shown.stream().flatMap(body -> body.entity().describeAt(x, y, tolerance).stream())
        .min(Comparator.comparingDouble(Description::distance));
  }
}
