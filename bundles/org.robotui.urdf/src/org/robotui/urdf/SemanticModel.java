package org.robotui.urdf;

import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * What an SRDF says of a robot.
 *
 * @param name of the robot
 * @param groups parts of the robot, those within them resolved
 * @param states named positions
 * @param disabledCollisions pairs of links that are not checked against each other
 */
public record SemanticModel(String name, List<Group> groups, List<GroupState> states,
    List<LinkPair> disabledCollisions) {
  /**
   * Copies the lists.
   *
   * @param name of the robot
   * @param groups parts
   * @param states positions
   * @param disabledCollisions pairs
   */
  public SemanticModel {
    groups = List.copyOf(groups);
    states = List.copyOf(states);
    disabledCollisions = List.copyOf(disabledCollisions);
  }

  /**
   * Finds a group.
   *
   * @param group its name
   * @return the group, or none
   */
  public Optional<Group> group(String group) {
    return groups.stream().filter(g -> g.name().equals(group)).findFirst();
  }

  /**
   * A part of a robot.
   *
   * @param name unique
   * @param joints its joints, also by chains and groups in it
   * @param links its links: named ones, and those that its joints carry
   */
  public record Group(String name, List<String> joints, List<String> links) {
    /**
     * Copies the lists.
     *
     * @param name unique
     * @param joints its joints
     * @param links its links
     */
    public Group {
      joints = List.copyOf(joints);
      links = List.copyOf(links);
    }
  }

  /**
   * A named position of a group.
   *
   * @param name for example {@code home}
   * @param group the group
   * @param positions by joint, radians or metres; of joints that one number says
   */
  public record GroupState(String name, String group, Map<String, Double> positions) {
    /**
     * Copies the positions.
     *
     * @param name of the state
     * @param group the group
     * @param positions by joint
     */
    public GroupState {
      positions = Map.copyOf(positions);
    }
  }

  /**
   * Two links.
   *
   * @param first one
   * @param second the other
   * @param reason why they need not be checked, may be empty
   */
  public record LinkPair(String first, String second, String reason) {}
}
