package org.robotui.entity.robotmodel.internal;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.robotui.data.FrameId;
import org.robotui.data.joint.JointState;
import org.robotui.geometry.RigidTransform;
import org.robotui.gl.display.Places;
import org.robotui.urdf.Link;
import org.robotui.urdf.RobotModel;

/**
 * Where links are in the fixed frame.
 *
 * @param fixedFromLinks by link; a link whose place is not known is missing
 * @param missing why, for the first one missing; empty where all are there
 */
record LinkPoses(Map<String, RigidTransform> fixedFromLinks, String missing) {
  /** Each link at its own frame. */
  static LinkPoses byTransforms(RobotModel model, String robot, String prefix, Places places) {
    Map<String, RigidTransform> found = HashMap.newHashMap(model.links().size());
    String missing = "";
    for (Link link : model.links()) {
      switch (places.at(frame(robot, prefix, link.name()), Optional.empty())) {
        case Places.Place.At(RigidTransform at) -> found.put(link.name(), at);
        case Places.Place.Missing(String reason) -> missing = missing.isEmpty() ? reason : missing;
      }
    }
    return new LinkPoses(found, missing);
  }

  /**
   * The root at its frame, the others as the joints say. Where no frame of the robot is known at all, the root stands
   * in the middle of the fixed frame: a robot without transforms can still be looked at.
   */
  static LinkPoses byJoints(Loaded.Model loaded, String robot, String prefix, Places places,
      Map<String, Double> positions) {
    return switch (root(loaded.model(), robot, prefix, places)) {
      case Places.Place.Missing(String reason) -> new LinkPoses(Map.of(), reason);
      case Places.Place.At(RigidTransform root) -> {
        Map<String, RigidTransform> links = new HashMap<>(loaded.kinematics().rootFromLinks(positions, Map.of()));
        links.replaceAll((link, at) -> root.times(at));
        yield new LinkPoses(links, "");
      }
    };
  }

  /** Where the root is: the middle of the fixed frame where no frame of the robot is known at all. */
  static Places.Place root(RobotModel model, String robot, String prefix, Places places) {
    Places.Place place = places.at(frame(robot, prefix, model.root()), Optional.empty());
    boolean placeless = places.all().stream().noneMatch(known -> known.robot().equals(robot));
    return place.found().isEmpty() && placeless ? new Places.Place.At(RigidTransform.IDENTITY) : place;
  }

  /** Takes over the positions of joints that the model has. */
  static Map<String, Double> newer(Map<String, Double> positions, JointState state, RobotModel model) {
    Map<String, Double> newer = new HashMap<>(positions);
    for (JointState.Joint joint : state.joints()) {
      if (Double.isFinite(joint.position()) && model.joint(joint.name()).isPresent()) {
        newer.put(joint.name(), joint.position());
      }
    }
    return Map.copyOf(newer);
  }

  private static FrameId frame(String robot, String prefix, String link) {
    return new FrameId(robot, prefix.isEmpty() ? link : prefix + "/" + link);
  }
}
