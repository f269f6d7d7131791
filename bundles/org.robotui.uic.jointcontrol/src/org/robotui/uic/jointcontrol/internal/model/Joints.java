package org.robotui.uic.jointcontrol.internal.model;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.robotui.data.joint.JointControl;
import org.robotui.data.joint.JointModel;

/**
 * All joints of a robot, at one moment.
 *
 * @param byName in the order of the robot's control
 * @param chains from base to tip; joints in none stand in a last one without a name
 * @param described whether the robot told its limits and chains
 */
public record Joints(Map<String, Seen> byName, List<JointModel.Chain> chains, boolean described) {
  private static final int NAMED = 4;

  /** Nothing came yet. */
  public static final Joints NONE = new Joints(Map.of(), List.of(), false);

  /**
   * One joint.
   *
   * @param model its limits
   * @param state what is measured and commanded
   */
  public record Seen(JointModel.Joint model, JointControl.Joint state) {}

  /** Joins what the robot told once with what it tells all the time. */
  public static Joints of(Optional<JointModel> model, JointControl control) {
    Map<String, JointModel.Joint> described = new HashMap<>();
    model.ifPresent(m -> m.joints().forEach(joint -> described.put(joint.name(), joint)));
    Map<String, Seen> seen = new LinkedHashMap<>();
    control.joints().forEach(
        state -> seen.put(state.name(), new Seen(described.getOrDefault(state.name(), unknown(state.name())), state)));
    return new Joints(seen, chains(model.map(JointModel::chains).orElse(List.of()), seen.keySet()), model.isPresent());
  }

  /** Without a description nothing is known but the name. */
  private static JointModel.Joint unknown(String name) {
    return new JointModel.Joint(name, -1, JointModel.Type.REVOLUTE, Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY,
        Double.NaN, Double.NaN);
  }

  private static List<JointModel.Chain> chains(List<JointModel.Chain> told, Set<String> names) {
    List<JointModel.Chain> chains = new ArrayList<>();
    Set<String> left = new LinkedHashSet<>(names);
    for (JointModel.Chain chain : told) {
      List<String> there = chain.joints().stream().filter(names::contains).toList();
      left.removeAll(there);
      if (!there.isEmpty()) {
        chains.add(new JointModel.Chain(chain.name(), there));
      }
    }
    if (!left.isEmpty()) {
      chains.add(new JointModel.Chain("", List.copyOf(left)));
    }
    return List.copyOf(chains);
  }

  /** One joint, where it is there. */
  public Optional<Seen> find(String name) {
    return Optional.ofNullable(byName.get(name));
  }

  /** What would move, as users read it: the chains, or the one joint. */
  String naming() {
    int count = byName.size();
    List<String> named = chains.stream().map(JointModel.Chain::name).filter(name -> !name.isEmpty()).toList();
    String joints = count == 1 ? "joint " + byName.keySet().iterator().next() : "all " + count + " joints";
    String more = named.size() > NAMED ? ", \u2026" : "";
    return named.isEmpty() ? joints
        : joints + " (" + String.join(", ", named.subList(0, Math.min(NAMED, named.size()))) + more + ")";
  }
}
