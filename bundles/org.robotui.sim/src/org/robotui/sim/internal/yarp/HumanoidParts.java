package org.robotui.sim.internal.yarp;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.robotui.urdf.Joint;
import org.robotui.urdf.Parsed;
import org.robotui.urdf.RobotModel;
import org.robotui.urdf.SemanticModel;
import org.robotui.urdf.Srdf;
import org.robotui.urdf.Urdf;

/**
 * The parts of a humanoid by the groups of its SRDF.
 *
 * @param name of the robot
 * @param parts joints by the names of the parts
 */
record HumanoidParts(String name, Map<String, PartJoints> parts) {
  private static final String BEGIN = "home";

  /** Reads a URDF, and the SRDF of the same name beside it. */
  static HumanoidParts read(Path urdf) throws IOException {
    RobotModel model = found(urdf, Urdf.parse(Files.readString(urdf)));
    Path srdf = urdf.resolveSibling(urdf.getFileName().toString().replaceFirst("\\.urdf$", ".srdf"));
    SemanticModel groups = found(srdf, Srdf.parse(Files.readString(srdf), model));
    return new HumanoidParts(groups.name(), parts(model, groups));
  }

  private static <T> T found(Path file, Parsed<T> parsed) throws IOException {
    return parsed.found().orElseThrow(() -> new IOException(file + " cannot be used: " + parsed));
  }

  /** A group that has joints of smaller ones is not a part, but several. */
  private static Map<String, PartJoints> parts(RobotModel model, SemanticModel semantic) {
    Map<String, Double> begin = new LinkedHashMap<>();
    semantic.states().stream().filter(state -> state.name().equals(BEGIN))
        .forEach(state -> begin.putAll(state.positions()));
    Map<String, PartJoints> parts = new LinkedHashMap<>();
    Set<Joint> taken = new HashSet<>();
    List<SemanticModel.Group> bySize = semantic.groups().stream()
        .sorted(Comparator.comparingInt(group -> group.joints().size())).toList();
    for (SemanticModel.Group group : bySize) {
      List<Joint> joints = group.joints().stream().map(model::joint).flatMap(Optional::stream)
          .filter(joint -> joint.type().single() && joint.mimic().isEmpty()).toList();
      if (!joints.isEmpty() && joints.stream().noneMatch(taken::contains)) {
        taken.addAll(joints);
        parts.put(group.name(), new PartJoints(joints,
            joints.stream().mapToDouble(joint -> begin.getOrDefault(joint.name(), 0.0)).toArray(),
            group.name().contains("leg")));
      }
    }
    return parts;
  }
}
