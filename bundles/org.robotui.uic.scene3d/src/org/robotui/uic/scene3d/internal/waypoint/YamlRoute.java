package org.robotui.uic.scene3d.internal.waypoint;

import java.io.StringReader;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robotui.geometry.RigidTransform;
import org.robotui.uic.scene3d.internal.SceneOptions;
import org.robotui.uic.scene3d.internal.waypoint.RouteText.Outcome;
import org.robotui.uic.scene3d.internal.waypoint.RouteText.RouteException;
import org.yaml.snakeyaml.LoaderOptions;
import org.yaml.snakeyaml.Yaml;
import org.yaml.snakeyaml.error.MarkedYAMLException;
import org.yaml.snakeyaml.error.YAMLException;
import org.yaml.snakeyaml.nodes.MappingNode;
import org.yaml.snakeyaml.nodes.Node;
import org.yaml.snakeyaml.nodes.NodeTuple;
import org.yaml.snakeyaml.nodes.ScalarNode;
import org.yaml.snakeyaml.nodes.SequenceNode;

/** Waypoints in YAML, read by its nodes: no tag constructs anything, and each fault has its line. */
final class YamlRoute {
  private static final int MAX_DEPTH = 10;

  private YamlRoute() {}

  static Outcome read(String text) throws RouteException {
    try {
      Node root = new Yaml(limits()).compose(new StringReader(text));
      if (root == null) {
        throw new RouteException(1, "it is empty: write " + String.join(" and ", RouteText.words()));
      }
      return route(root);
    } catch (MarkedYAMLException e) {
      int line = Optional.ofNullable(e.getProblemMark()).map(mark -> mark.getLine() + 1).orElse(1);
      throw new RouteException(line, "this is no YAML: " + e.getProblem());
    } catch (YAMLException e) {
      throw new RouteException(1, "this is no YAML: " + e.getMessage());
    }
  }

  private static LoaderOptions limits() {
    LoaderOptions options = new LoaderOptions();
    options.setNestingDepthLimit(MAX_DEPTH);
    options.setCodePointLimit(RouteText.MOST);
    options.setAllowRecursiveKeys(false);
    return options;
  }

  private static Outcome route(Node root) throws RouteException {
    Optional<String> frame = Optional.empty();
    List<RigidTransform> poses = List.of();
    for (NodeTuple entry : section(root, "waypoints").getValue()) {
      String name = scalar(entry.getKeyNode(), "a name");
      switch (name) {
        case SceneOptions.WAYPOINT_FRAME -> frame =
            Optional.of(scalar(entry.getValueNode(), "a frame").strip()).filter(f -> !f.isEmpty());
        case SceneOptions.WAYPOINTS -> poses = poses(entry.getValueNode());
        default -> throw new RouteException(line(entry.getKeyNode()),
            "'" + name + "' is not known here: write " + String.join(" or ", RouteText.words()));
      }
    }
    return new Outcome.Read(frame, poses);
  }

  private static List<RigidTransform> poses(Node node) throws RouteException {
    if (!(node instanceof SequenceNode list)) {
      throw new RouteException(line(node), "a list of waypoints is expected, each as - {x: 1, y: 2, z: 0, yaw: 0}");
    }
    List<RigidTransform> poses = new ArrayList<>();
    for (Node item : list.getValue()) {
      double[] numbers = new double[RouteText.NUMBERS.size()];
      for (NodeTuple entry : section(item, "a waypoint as {x: 1, y: 2, z: 0, yaw: 0}").getValue()) {
        String name = scalar(entry.getKeyNode(), "a name");
        int index = RouteText.NUMBERS.indexOf(name);
        if (index < 0) {
          throw new RouteException(line(entry.getKeyNode()),
              "'" + name + "' is no part of a waypoint: x, y, z and yaw are");
        }
        numbers[index] = RouteText.number(scalar(entry.getValueNode(), "a number"), name, line(entry.getValueNode()));
      }
      poses.add(RouteText.pose(numbers, line(item), poses.size()));
    }
    return poses;
  }

  private static MappingNode section(Node node, String what) throws RouteException {
    if (node instanceof MappingNode section) {
      return section;
    }
    throw new RouteException(line(node), what + " is expected here");
  }

  private static String scalar(Node node, String what) throws RouteException {
    if (node instanceof ScalarNode scalar) {
      return scalar.getValue();
    }
    throw new RouteException(line(node), what + " is expected here");
  }

  private static int line(Node node) {
    return node.getStartMark().getLine() + 1;
  }
}
