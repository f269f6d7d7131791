package org.robotui.urdf;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;

/** A robot: a tree of links, joined by joints. */
public final class RobotModel {
  private final String name;
  private final String root;
  private final List<Link> links;
  private final List<Joint> joints;
  private final Map<String, Link> linkByName;
  private final Map<String, Joint> jointByName;
  private final Map<String, Joint> jointByChild;

  /** Takes what was found to be a tree. */
  RobotModel(String name, String root, List<Link> links, List<Joint> joints) {
    this.name = name;
    this.root = root;
    this.links = List.copyOf(links);
    this.joints = List.copyOf(joints);
    this.linkByName = by(links, Link::name);
    this.jointByName = by(joints, Joint::name);
    this.jointByChild = by(joints, Joint::child);
  }

  /**
   * The name of the robot.
   *
   * @return as written
   */
  public String name() {
    return name;
  }

  /**
   * The link that no joint carries.
   *
   * @return its name
   */
  public String root() {
    return root;
  }

  /**
   * All links.
   *
   * @return in the order of the text
   */
  public List<Link> links() {
    return links;
  }

  /**
   * All joints.
   *
   * @return in the order of the tree: each behind the joint that carries its parent
   */
  public List<Joint> joints() {
    return joints;
  }

  /**
   * Finds a link.
   *
   * @param link its name
   * @return the link, or none
   */
  public Optional<Link> link(String link) {
    return Optional.ofNullable(linkByName.get(link));
  }

  /**
   * Finds a joint.
   *
   * @param joint its name
   * @return the joint, or none
   */
  public Optional<Joint> joint(String joint) {
    return Optional.ofNullable(jointByName.get(joint));
  }

  /**
   * The joint that carries a link.
   *
   * @param link its name
   * @return the joint, or none for the root
   */
  public Optional<Joint> carrier(String link) {
    return Optional.ofNullable(jointByChild.get(link));
  }

  private static <T> Map<String, T> by(List<T> all, Function<T, String> name) {
    return all.stream().collect(Collectors.toUnmodifiableMap(name, Function.identity()));
  }
}
