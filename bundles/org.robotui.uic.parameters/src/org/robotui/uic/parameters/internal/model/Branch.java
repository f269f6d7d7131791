package org.robotui.uic.parameters.internal.model;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;

/**
 * A namespace with what lies in it, or a parameter.
 *
 * @param key which one
 * @param label the last part of its name
 * @param parameter whether it is a parameter itself
 * @param children what lies in it, sorted by name
 * @param leaves how many parameters lie in it
 */
public record Branch(Key key, String label, boolean parameter, List<Branch> children, int leaves) {
  private static final int DEEPEST = 64;

  /** The parts of a name; what lies deeper than any sensible name stays in one part. */
  static List<String> parts(String name) {
    String begun = name.startsWith("/") ? name.substring(1) : name;
    return Stream.of(begun.split("/", DEEPEST)).filter(part -> !part.isEmpty()).toList();
  }

  /** The tree of a robot's parameters. */
  static Branch tree(String robot, Collection<String> names) {
    Sprout root = new Sprout();
    for (String name : names) {
      Sprout at = root;
      for (String part : parts(name)) {
        at = at.children.computeIfAbsent(part, p -> new Sprout());
      }
      at.parameter = true;
    }
    return root.grown(new Key(robot, ""), robot);
  }

  /** Whether something lies in it. */
  boolean isNamespace() {
    return !children.isEmpty();
  }

  /** All parameters in it, itself included. */
  List<Key> parameters() {
    List<Key> all = new ArrayList<>();
    collect(all);
    return all;
  }

  private void collect(List<Key> all) {
    if (parameter) {
      all.add(key);
    }
    children.forEach(child -> child.collect(all));
  }

  /** A branch that still grows. */
  private static final class Sprout {
    private final Map<String, Sprout> children = new TreeMap<>();
    private boolean parameter;

    Branch grown(Key key, String label) {
      List<Branch> branches = new ArrayList<>();
      children
          .forEach((part, sprout) -> branches.add(sprout.grown(new Key(key.robot(), key.name() + "/" + part), part)));
      int leaves = branches.stream().mapToInt(Branch::leaves).sum() + (parameter ? 1 : 0);
      return new Branch(key, label, parameter, List.copyOf(branches), leaves);
    }
  }
}
