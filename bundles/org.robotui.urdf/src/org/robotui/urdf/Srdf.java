package org.robotui.urdf;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.robotui.urdf.internal.Numbers;
import org.robotui.urdf.internal.Refusal;
import org.robotui.urdf.internal.XmlLimits;
import org.robotui.urdf.internal.XmlNode;
import org.robotui.urdf.internal.XmlReader;

/** Reads SRDF. Safe for all threads. */
public final class Srdf {
  private static final int DEEPEST = 32;
  private static final int MOST_MEMBERS = 1_000_000;

  private final RobotModel model;
  private final List<Problem> warnings = new ArrayList<>();
  private final Map<String, XmlNode> groupNodes = new LinkedHashMap<>();
  private final Map<String, SemanticModel.Group> groups = new HashMap<>();
  private int members;

  private Srdf(RobotModel model) {
    this.model = model;
  }

  /**
   * Reads what is said of a robot. What names a link or joint that the robot lacks is left out with a warning.
   *
   * @param text the XML, 16 million characters at most
   * @param model the robot it belongs to
   * @return what it says, or the first thing that is wrong, with its line
   */
  public static Parsed<SemanticModel> parse(String text, RobotModel model) {
    try {
      Srdf reader = new Srdf(model);
      SemanticModel read = reader.read(XmlReader.read(text, XmlLimits.DESCRIPTION));
      return new Parsed.Ok<>(read, reader.warnings);
    } catch (Refusal refusal) {
      return new Parsed.Refused<>(new Problem(refusal.line(), refusal.getMessage()));
    }
  }

  private SemanticModel read(XmlNode robot) throws Refusal {
    if (!robot.name().equals("robot")) {
      throw robot.refusal("the outermost element is <" + robot.name() + ">, must be <robot name=\"...\"> of an SRDF");
    }
    for (XmlNode node : robot.children("group")) {
      groupNodes.put(node.required("name"), node);
    }
    List<SemanticModel.Group> resolved = new ArrayList<>();
    for (String name : groupNodes.keySet()) {
      resolved.add(group(name, 0));
    }
    List<SemanticModel.GroupState> states = new ArrayList<>();
    for (XmlNode node : robot.children("group_state")) {
      states.add(state(node));
    }
    List<SemanticModel.LinkPair> pairs = new ArrayList<>();
    for (XmlNode node : robot.children("disable_collisions")) {
      pairs.add(new SemanticModel.LinkPair(node.required("link1"), node.required("link2"),
          node.attribute("reason").orElse("")));
    }
    return new SemanticModel(robot.attribute("name").orElse(""), resolved, states, pairs);
  }

  private SemanticModel.Group group(String name, int depth) throws Refusal {
    SemanticModel.Group known = groups.get(name);
    if (known != null) {
      return known;
    }
    XmlNode node = groupNodes.get(name);
    if (depth > DEEPEST) {
      throw node.refusal(
          "the group '" + name + "' contains itself, or groups lie more than " + DEEPEST + " deep in each other");
    }
    Set<String> joints = new LinkedHashSet<>();
    Set<String> links = new LinkedHashSet<>();
    for (XmlNode member : node.children()) {
      switch (member.name()) {
        case "joint" -> joint(member).ifPresent(joints::add);
        case "link" -> link(member, "name").ifPresent(links::add);
        case "chain" -> joints.addAll(chain(member));
        case "group" -> nested(member, depth, joints, links);
        default -> warnings.add(new Problem(member.line(), "<" + member.name() + "> in a group is not known"));
      }
    }
    joints.forEach(joint -> model.joint(joint).ifPresent(j -> links.add(j.child())));
    members += joints.size() + links.size();
    if (members > MOST_MEMBERS) {
      throw node.refusal("groups have more than " + MOST_MEMBERS + " members");
    }
    SemanticModel.Group made = new SemanticModel.Group(name, List.copyOf(joints), List.copyOf(links));
    groups.put(name, made);
    return made;
  }

  private void nested(XmlNode member, int depth, Set<String> joints, Set<String> links) throws Refusal {
    String name = member.required("name");
    if (!groupNodes.containsKey(name)) {
      warnings.add(new Problem(member.line(), "there is no group '" + name + "'"));
      return;
    }
    SemanticModel.Group inner = group(name, depth + 1);
    joints.addAll(inner.joints());
    links.addAll(inner.links());
  }

  private Optional<String> joint(XmlNode node) throws Refusal {
    String name = node.required("name");
    if (model.joint(name).isEmpty()) {
      warnings.add(new Problem(node.line(), "the robot has no joint '" + name + "'"));
      return Optional.empty();
    }
    return Optional.of(name);
  }

  private Optional<String> link(XmlNode node, String attribute) throws Refusal {
    String name = node.required(attribute);
    if (model.link(name).isEmpty()) {
      warnings.add(new Problem(node.line(), "the robot has no link '" + name + "'"));
      return Optional.empty();
    }
    return Optional.of(name);
  }

  /** The joints from the tip down to the base, base first. */
  private List<String> chain(XmlNode node) throws Refusal {
    Optional<String> base = link(node, "base_link");
    Optional<String> tip = link(node, "tip_link");
    List<String> joints = new ArrayList<>();
    if (base.isEmpty() || tip.isEmpty()) {
      return joints;
    }
    Optional<Joint> carrier = model.carrier(tip.get());
    String at = tip.get();
    while (!at.equals(base.get()) && carrier.isPresent()) {
      joints.addFirst(carrier.get().name());
      at = carrier.get().parent();
      carrier = model.carrier(at);
    }
    if (!at.equals(base.get())) {
      warnings
          .add(new Problem(node.line(), "no joints lead from the link '" + base.get() + "' to '" + tip.get() + "'"));
      return List.of();
    }
    return joints;
  }

  private SemanticModel.GroupState state(XmlNode node) throws Refusal {
    Map<String, Double> positions = new HashMap<>();
    for (XmlNode joint : node.children("joint")) {
      Optional<String> name = joint(joint);
      double[] values = Numbers.all(joint, "value");
      if (name.isPresent() && values.length == 1) {
        positions.put(name.get(), values[0]);
      }
    }
    return new SemanticModel.GroupState(node.required("name"), node.required("group"), positions);
  }
}
