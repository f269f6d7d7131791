package org.robotui.urdf;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.robotui.urdf.internal.Refusal;
import org.robotui.urdf.internal.XmlLimits;
import org.robotui.urdf.internal.XmlNode;
import org.robotui.urdf.internal.XmlReader;

/** Reads URDF. Safe for all threads. */
public final class Urdf {
  private static final int MOST_LINKS = 10_000;

  private final List<Problem> warnings = new ArrayList<>();
  private final UrdfSurfaces surfaces = new UrdfSurfaces(warnings);

  private Urdf() {}

  /**
   * Reads a model. Elements that URDF does not know (of simulators and controllers) are passed over.
   *
   * @param text the XML, 16 million characters at most
   * @return the model, or the first thing that is wrong, with its line
   */
  public static Parsed<RobotModel> parse(String text) {
    try {
      Urdf reader = new Urdf();
      RobotModel model = reader.read(XmlReader.read(text, XmlLimits.DESCRIPTION));
      return new Parsed.Ok<>(model, reader.warnings);
    } catch (Refusal refusal) {
      return new Parsed.Refused<>(new Problem(refusal.line(), refusal.getMessage()));
    }
  }

  private RobotModel read(XmlNode robot) throws Refusal {
    if (!robot.name().equals("robot")) {
      throw robot.refusal("the outermost element is <" + robot.name()
          + ">, must be <robot name=\"...\"> of a URDF (a xacro file must be expanded first)");
    }
    surfaces.global(robot.children("material"));
    Map<String, XmlNode> linkNodes = unique(robot.children("link"));
    List<Link> links = new ArrayList<>();
    LinkReader linkReader = new LinkReader(surfaces);
    for (XmlNode node : linkNodes.values()) {
      links.add(linkReader.read(node));
    }
    surfaces.resolveLate();
    if (links.isEmpty()) {
      throw robot.refusal("the robot has no <link>, must have one at least");
    }
    Map<String, XmlNode> jointNodes = unique(robot.children("joint"));
    List<Joint> joints = new ArrayList<>();
    for (XmlNode node : jointNodes.values()) {
      joints.add(JointReader.read(node));
    }
    JointReader.checkMimics(joints, jointNodes);
    UrdfTree tree = UrdfTree.check(robot, linkNodes.keySet(), joints, jointNodes);
    return new RobotModel(robot.attribute("name").orElse(""), tree.root(), surfaces.applied(links), tree.ordered());
  }

  private static Map<String, XmlNode> unique(List<XmlNode> nodes) throws Refusal {
    Map<String, XmlNode> byName = new LinkedHashMap<>();
    if (nodes.size() > MOST_LINKS) {
      throw nodes.get(MOST_LINKS).refusal("more than " + MOST_LINKS + " elements <" + nodes.get(0).name() + ">");
    }
    for (XmlNode node : nodes) {
      String name = node.required("name");
      XmlNode earlier = byName.putIfAbsent(name, node);
      if (earlier != null) {
        throw node.refusal("a second <" + node.name() + "> has the name '" + name + "' (the first is in line "
            + earlier.line() + "); names must be unique");
      }
    }
    return byName;
  }

  /** Which link carries all, and the joints from there on. */
  private record UrdfTree(String root, List<Joint> ordered) {
    static UrdfTree check(XmlNode robot, Set<String> links, List<Joint> joints, Map<String, XmlNode> nodes)
        throws Refusal {
      Map<String, Joint> carriers = new LinkedHashMap<>();
      for (Joint joint : joints) {
        known(links, joint.parent(), "parent", nodes.get(joint.name()));
        known(links, joint.child(), "child", nodes.get(joint.name()));
        Joint other = carriers.putIfAbsent(joint.child(), joint);
        if (other != null) {
          throw nodes.get(joint.name()).refusal("the link '" + joint.child() + "' is child of both joints '"
              + other.name() + "' and '" + joint.name() + "'; a link has one parent");
        }
      }
      List<String> roots = links.stream().filter(link -> !carriers.containsKey(link)).toList();
      if (roots.size() > 1) {
        throw robot.refusal("the links '" + roots.get(0) + "' and '" + roots.get(1)
            + "' have no parent both; all but one link must be child of a joint");
      }
      for (String link : links) {
        acyclic(link, carriers, nodes);
      }
      return new UrdfTree(roots.get(0), order(roots.get(0), joints));
    }

    private static void known(Set<String> links, String link, String role, XmlNode joint) throws Refusal {
      if (!links.contains(link)) {
        throw joint.refusal("the joint '" + joint.attribute("name").orElse("") + "' has the " + role + " '" + link
            + "', but there is no such <link>");
      }
    }

    private static void acyclic(String start, Map<String, Joint> carriers, Map<String, XmlNode> nodes) throws Refusal {
      int steps = 0;
      Optional<Joint> carrier = Optional.ofNullable(carriers.get(start));
      while (carrier.isPresent()) {
        Joint joint = carrier.get();
        if (joint.parent().equals(start) || steps++ > carriers.size()) {
          throw nodes.get(joint.name()).refusal(
              "the link '" + start + "' carries itself, by the joint '" + joint.name() + "'; joints must make a tree");
        }
        carrier = Optional.ofNullable(carriers.get(joint.parent()));
      }
    }

    private static List<Joint> order(String root, List<Joint> joints) {
      Map<String, List<Joint>> byParent = new LinkedHashMap<>();
      joints.forEach(joint -> byParent.computeIfAbsent(joint.parent(), parent -> new ArrayList<>()).add(joint));
      List<Joint> ordered = new ArrayList<>();
      Set<String> seen = new HashSet<>();
      List<String> next = new ArrayList<>(List.of(root));
      for (int i = 0; i < next.size(); i++) {
        for (Joint joint : seen.add(next.get(i)) ? byParent.getOrDefault(next.get(i), List.of()) : List.<Joint>of()) {
          ordered.add(joint);
          next.add(joint.child());
        }
      }
      return ordered;
    }
  }
}
