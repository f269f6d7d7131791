package org.robotui.uic.map.internal.model;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.frame.Frames;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.Input;
import org.robotui.api.port.InputState;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.geometry.RigidTransform;
import org.robotui.ui.layer.SeenRobot;
import org.robotui.ui.scene.Placer;

/** Where robots are: by transforms where there are any, else by odometry, else by an estimate. Worker thread. */
final class Robots {
  private static final List<String> BASES = List.of("base_footprint", "base_link");

  private final Frames frames;
  private final Input<Odometry> odometry;
  private final Input<PoseEstimate> poses;
  private final Team team;

  Robots(Frames frames, Input<Odometry> odometry, Input<PoseEstimate> poses, Team team) {
    this.frames = frames;
    this.odometry = odometry;
    this.poses = poses;
    this.team = team;
  }

  List<SeenRobot> find(Placer placer) {
    Map<String, SeenRobot> found = new LinkedHashMap<>();
    for (Envelope<Odometry> o : newest(odometry)) {
      byOdometry(placer, o).ifPresent(place -> put(found, o.value().frame().robot(), place, speed(o.value())));
    }
    for (FrameId frame : frames.all()) {
      if (BASES.contains(frame.name()) && !found.containsKey(frame.robot())) {
        placer.latest(frame).found().ifPresent(place -> put(found, frame.robot(), place, 0));
      }
    }
    for (Envelope<PoseEstimate> e : newest(poses)) {
      FrameId frame = e.value().frame();
      placer.latest(frame).found().ifPresent(t -> put(found, frame.robot(), t.times(e.value().pose()), 0));
    }
    return List.copyOf(found.values());
  }

  private void put(Map<String, SeenRobot> found, String robot, RigidTransform place, double speed) {
    int number = team.isSeveral() ? team.number(robot) : found.size();
    found.putIfAbsent(robot,
        new SeenRobot(robot, place, speed, number, team.selected().contains(robot), isStale(robot)));
  }

  private static double speed(Odometry o) {
    return Math.hypot(o.linear().x(), o.linear().y());
  }

  private static Optional<RigidTransform> byOdometry(Placer placer, Envelope<Odometry> envelope) {
    Odometry o = envelope.value();
    FrameId base = o.childFrame();
    Optional<RigidTransform> byTransform = base.name().isEmpty() ? Optional.empty() : placer.latest(base).found();
    return byTransform.or(() -> placer.at(o.frame(), envelope.stamp()).found().map(t -> t.times(o.pose())));
  }

  private boolean isStale(String robot) {
    return odometry.sources().stream()
        .filter(id -> odometry.latest(id).filter(e -> e.value().frame().robot().equals(robot)).isPresent())
        .findFirst()
        .filter(id -> odometry.state(id) instanceof InputState.Stale)
        .isPresent();
  }

  private static <T extends Data> List<Envelope<T>> newest(Input<T> input) {
    List<Envelope<T>> all = new ArrayList<>();
    input.sources().forEach(id -> input.latest(id).ifPresent(all::add));
    return all;
  }
}
