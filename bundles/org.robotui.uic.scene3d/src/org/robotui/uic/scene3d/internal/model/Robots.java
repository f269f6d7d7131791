package org.robotui.uic.scene3d.internal.model;

import java.util.Collection;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.robotui.data.FrameId;
import org.robotui.geometry.RigidTransform;
import org.robotui.gl.shape.Rgba;

/** Finds the robots of a scene by their base frames. */
final class Robots {
  private static final List<String> BASES = List.of("base_footprint", "base_link", "base", "pelvis");

  private Robots() {}

  /** The base frame of a robot; where no robot has the name, that of the first one. */
  static Optional<FrameId> base(String robot, List<FrameId> frames) {
    Comparator<FrameId> likely =
        Comparator.comparing((FrameId f) -> !f.robot().equals(robot)).thenComparing(f -> BASES.indexOf(f.name()));
    return frames.stream().filter(f -> BASES.contains(f.name())).min(likely);
  }

  static List<Stage.Robot> find(ScenePlaces places, Collection<FrameId> named, Function<String, Rgba> colors) {
    Map<String, Optional<RigidTransform>> found = new LinkedHashMap<>();
    places.all().forEach(f -> found.putIfAbsent(f.robot(), Optional.empty()));
    named.forEach(f -> found.putIfAbsent(f.robot(), Optional.empty()));
    List<FrameId> frames = places.all();
    found.replaceAll((robot, none) -> BASES.stream().map(base -> new FrameId(robot, base)).filter(frames::contains)
        .flatMap(base -> places.at(base, Optional.empty()).found().stream()).findFirst());
    return found.entrySet().stream().map(e -> new Stage.Robot(e.getKey(), colors.apply(e.getKey()), e.getValue()))
        .toList();
  }
}
