package org.robotui.uic.connections.internal.model;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/**
 * All that the view shows, at one moment.
 *
 * @param branches a RUIC each, in the order of the workbench
 * @param summary how everything is doing, in a line
 */
public record ConnectionsLook(List<Branch> branches, String summary) {
  /** Nothing is known yet. */
  public static final ConnectionsLook NONE = new ConnectionsLook(List.of(), "");

  /** Copies the list. */
  public ConnectionsLook {
    branches = List.copyOf(branches);
  }

  /**
   * A RUIC.
   *
   * @param robot its line
   * @param parts its components
   */
  public record Branch(ConnectionLine.Robot robot, List<ConnectionLine.Part> parts) {}

  /** The names of all RUICs. */
  public List<String> names() {
    return branches.stream().map(branch -> branch.robot().ruic()).toList();
  }

  /**
   * The lines to list: what fits, below what it belongs to. What is folded is closed only while nothing narrows the
   * list.
   *
   * @param filter which lines are wanted
   * @param folded the keys of lines below which nothing is shown
   */
  public List<ConnectionLine> lines(Filter filter, Set<String> folded) {
    List<ConnectionLine> lines = new ArrayList<>();
    for (Branch branch : branches) {
      if (filter.admits(branch.robot().ruic())) {
        lines(branch, filter, filter.narrows() ? Set.of() : folded, lines);
      }
    }
    return List.copyOf(lines);
  }

  private static void lines(Branch branch, Filter filter, Set<String> folded, List<ConnectionLine> lines) {
    List<ConnectionLine> below = new ArrayList<>();
    branch.parts().forEach(part -> lines(part, filter, folded, below));
    if (!below.isEmpty() || filter.fits(branch.robot())) {
      lines.add(branch.robot());
      if (!folded.contains(branch.robot().key())) {
        lines.addAll(below);
      }
    }
  }

  private static void lines(ConnectionLine.Part part, Filter filter, Set<String> folded, List<ConnectionLine> lines) {
    List<ConnectionLine> ports = part.ports().stream().filter(filter::fits).toList();
    if (!ports.isEmpty() || filter.fits(part)) {
      lines.add(part);
      if (!folded.contains(part.key())) {
        lines.addAll(ports);
      }
    }
  }
}
