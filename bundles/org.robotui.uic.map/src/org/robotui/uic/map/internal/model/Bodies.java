package org.robotui.uic.map.internal.model;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.robotui.api.frame.Frames;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.Input;
import org.robotui.api.port.InputState;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.geometry.Footprint;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.entity.robot.Body;
import org.robotui.entity.robot.RobotEntity;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.ui.Figures;
import org.robotui.ui.scene.Layer;
import org.robotui.ui.scene.Placer;
import org.robotui.ui.scene.Scene;
import org.robotui.uic.map.internal.Kind;

/** The bodies of robots: by transforms where there are any, else by odometry, else by an estimate. Worker thread. */
final class Bodies {
  private static final String LAYER = Kind.ROBOT.word() + ":";
  private static final List<String> BASES = List.of("base_footprint", "base_link");

  private final Frames frames;
  private final Input<Odometry> odometry;
  private final Input<PoseEstimate> poses;
  private final Input<Footprint> footprints;
  private final Scene scene;
  private final Team team;
  private final Map<String, RobotEntity> entities = new LinkedHashMap<>();

  Bodies(
      Frames frames, Input<Odometry> odometry, Input<PoseEstimate> poses, Input<Footprint> footprints, Scene scene,
      Team team) {
    this.frames = frames;
    this.odometry = odometry;
    this.poses = poses;
    this.footprints = footprints;
    this.scene = scene;
    this.team = team;
  }

  /** Finds the robots and prepares their bodies. */
  List<RobotPlace> tick(TickContext tick) {
    List<RobotPlace> places = tick.placer().map(this::find).orElse(List.of());
    Set<String> gone = new LinkedHashSet<>(entities.keySet());
    for (RobotPlace place : places) {
      gone.remove(place.robot());
      prepare(place, tick, places.size() > 1);
    }
    gone.forEach(robot -> {
      entities.remove(robot);
      scene.remove(layer(robot));
    });
    return places;
  }

  private List<RobotPlace> find(Placer placer) {
    Map<String, RobotPlace> found = new LinkedHashMap<>();
    for (Envelope<Odometry> o : newest(odometry)) {
      byOdometry(placer, o).ifPresent(p -> found.putIfAbsent(p.robot(), p));
    }
    for (FrameId frame : frames.all()) {
      if (BASES.contains(frame.name()) && !found.containsKey(frame.robot())) {
        placer.latest(frame).found().ifPresent(t -> found.put(frame.robot(), new RobotPlace(frame.robot(), t, 0)));
      }
    }
    for (Envelope<PoseEstimate> e : newest(poses)) {
      FrameId frame = e.value().frame();
      placer.latest(frame).found().ifPresent(
          t -> found.putIfAbsent(frame.robot(), new RobotPlace(frame.robot(), t.times(e.value().pose()), 0)));
    }
    return List.copyOf(found.values());
  }

  private Optional<RobotPlace> byOdometry(Placer placer, Envelope<Odometry> envelope) {
    Odometry o = envelope.value();
    double speed = Math.hypot(o.linear().x(), o.linear().y());
    FrameId base = o.childFrame();
    Optional<RigidTransform> byTransform = base.name().isEmpty() ? Optional.empty() : placer.latest(base).found();
    return byTransform
        .or(() -> placer.at(o.frame(), envelope.stamp()).found().map(t -> t.times(o.pose())))
        .map(t -> new RobotPlace(o.frame().robot(), t, speed));
  }

  private void prepare(RobotPlace place, TickContext tick, boolean named) {
    RobotEntity entity = entities.computeIfAbsent(place.robot(), this::add);
    Optional<List<Vector3>> outline = tick.placer().flatMap(p -> outline(p, place));
    double radius = outline.map(corners -> radius(corners, place)).orElse(tick.options().robotRadius());
    entity.showName(named);
    entity.select(team.selected().contains(place.robot()));
    entity.prepare(new Body(place.robot(), place.fixedFromBase(), radius, outline, words(place)));
    scene.find(layer(place.robot())).ifPresent(l -> {
      l.show(tick.options().shows(Kind.ROBOT, l.id()));
      l.fade(stale(place.robot()));
    });
  }

  private RobotEntity add(String robot) {
    RobotEntity entity = new RobotEntity(team.isSeveral() ? team.number(robot) : entities.size());
    scene.add(new Layer(layer(robot), Kind.ROBOT.ordinal(), robot, entity));
    return entity;
  }

  private Optional<List<Vector3>> outline(Placer placer, RobotPlace place) {
    return newest(footprints).stream()
        .filter(e -> e.value().frame().robot().equals(place.robot()))
        .findFirst()
        .flatMap(e -> placer.at(e.value().frame(), e.stamp()).found()
            .or(() -> placer.latest(e.value().frame()).found())
            .map(t -> e.value().corners().stream().map(t::apply).toList()));
  }

  private boolean stale(String robot) {
    return odometry.sources().stream()
        .filter(id -> odometry.latest(id).filter(e -> e.value().frame().robot().equals(robot)).isPresent())
        .findFirst()
        .filter(id -> odometry.state(id) instanceof InputState.Stale)
        .isPresent();
  }

  private static double radius(List<Vector3> corners, RobotPlace place) {
    Vector3 at = place.fixedFromBase().translation();
    return Math.max(0.01,
        corners.stream().mapToDouble(c -> Math.hypot(c.x() - at.x(), c.y() - at.y())).max().orElse(0));
  }

  private static String words(RobotPlace place) {
    Vector3 at = place.fixedFromBase().translation();
    return "x " + Figures.fixed(at.x(), 2) + "  y " + Figures.of(at.y(), 2, "m")
        + "  " + Figures.degrees(place.fixedFromBase().rotation().yaw(), 1);
  }

  private static String layer(String robot) {
    return LAYER + robot;
  }

  private static <T extends Data> List<Envelope<T>> newest(Input<T> input) {
    List<Envelope<T>> all = new ArrayList<>();
    input.sources().forEach(id -> input.latest(id).ifPresent(all::add));
    return all;
  }
}
