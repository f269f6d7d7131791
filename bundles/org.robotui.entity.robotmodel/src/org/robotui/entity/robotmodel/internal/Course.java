package org.robotui.entity.robotmodel.internal;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.urdf.Joint;
import org.robotui.urdf.Link;
import org.robotui.urdf.RobotModel;

/** What a plan moves in space, in the frame of the model's root. Safe for all threads. */
final class Course {
  private static final int MOST_CORNERS = 1_000;

  private final Loaded.Model loaded;
  private final Plan plan;
  private final Map<String, Integer> moved;

  Course(Loaded.Model loaded, Plan plan) {
    this.loaded = loaded;
    this.plan = plan;
    moved = moved(loaded.model(), plan.joints().stream().map(Joint::name).collect(Collectors.toSet()));
  }

  Loaded.Model loaded() {
    return loaded;
  }

  Plan plan() {
    return plan;
  }

  /** The links that are elsewhere when joints of the plan move. */
  List<Link> links() {
    return loaded.model().links().stream().filter(link -> moved.get(link.name()) > 0).toList();
  }

  /**
   * The link that most of the joints move; of several, the one farthest from the root: a tool rather than the wrist
   * that carries it.
   */
  String tip() {
    String tip = loaded.model().root();
    Map<String, Integer> depths = new HashMap<>(Map.of(tip, 0));
    for (Joint joint : loaded.model().joints()) {
      String link = joint.child();
      depths.put(link, depths.get(joint.parent()) + 1);
      int more = moved.get(link) - moved.get(tip);
      tip = more > 0 || more == 0 && depths.get(link) > depths.get(tip) ? link : tip;
    }
    return tip;
  }

  /** Root from link, by name. */
  Map<String, RigidTransform> places(Map<String, Double> positions) {
    return loaded.kinematics().rootFromLinks(positions, Map.of());
  }

  /** Where a link goes: x, y, z of its origin at the points of the plan, evenly left out where they are many. */
  float[] way(String link) {
    int every = (plan.points() + MOST_CORNERS - 1) / MOST_CORNERS;
    int[] points = IntStream.range(0, plan.points()).filter(i -> i % every == 0 || i == plan.points() - 1).toArray();
    float[] xyz = new float[3 * points.length];
    for (int i = 0; i < points.length; i++) {
      Vector3 at = places(plan.at(points[i])).get(link).translation();
      xyz[3 * i] = (float) at.x();
      xyz[3 * i + 1] = (float) at.y();
      xyz[3 * i + 2] = (float) at.z();
    }
    return xyz;
  }

  /** How many joints of the plan carry each link. */
  private static Map<String, Integer> moved(RobotModel model, Set<String> planned) {
    Map<String, Integer> moved = new HashMap<>(Map.of(model.root(), 0));
    for (Joint joint : model.joints()) {
      moved.put(joint.child(), moved.get(joint.parent()) + (moves(joint, model, planned) ? 1 : 0));
    }
    return moved;
  }

  private static boolean moves(Joint joint, RobotModel model, Set<String> planned) {
    return joint.mimic()
        .map(mimic -> model.joint(mimic.joint()).filter(leader -> moves(leader, model, planned)).isPresent())
        .orElse(planned.contains(joint.name()));
  }
}
