package org.robotui.ui.diagram;

import java.util.List;
import java.util.Optional;
import org.robotui.ui.Role;

/**
 * What leads from one box to another.
 *
 * @param from key of the box where it begins
 * @param to key of the box where it ends, with a head there
 * @param corners where it goes along, the ends among them; at least two
 * @param label what is written on it, may be empty
 * @param room the middle of the room that was left for the label; none where it stands on the longest part
 * @param role its colour
 * @param dashed whether it is interrupted
 */
public record Wire(Object from, Object to, List<Corner> corners, String label, Optional<Corner> room, Role role,
    boolean dashed) {
  /**
   * A place where a wire goes along.
   *
   * @param x points from the left
   * @param y points from the top
   */
  public record Corner(double x, double y) {}

  /**
   * Copies the corners.
   *
   * @param from key of a box
   * @param to key of a box
   * @param corners where it goes along
   * @param label what is written
   * @param room where
   * @param role its colour
   * @param dashed interrupted
   */
  public Wire {
    corners = List.copyOf(corners);
    if (corners.size() < 2) {
      throw new IllegalArgumentException("a wire has two ends");
    }
  }

  /**
   * A wire without room for a label.
   *
   * @param from key of a box
   * @param to key of a box
   * @param corners where it goes along
   * @param label what is written
   * @param role its colour
   * @param dashed interrupted
   */
  public Wire(Object from, Object to, List<Corner> corners, String label, Role role, boolean dashed) {
    this(from, to, corners, label, Optional.empty(), role, dashed);
  }

  /**
   * The same wire with another label.
   *
   * @param words what is written
   * @return the wire
   */
  public Wire labelled(String words) {
    return new Wire(from, to, corners, words, room, role, dashed);
  }

  /**
   * Where the middle of the label stands.
   *
   * @return the place
   */
  public Corner middle() {
    return room.orElseGet(this::longest);
  }

  private Corner longest() {
    Corner best = corners.getFirst();
    double longest = -1;
    for (int i = 0; i + 1 < corners.size(); i++) {
      Corner a = corners.get(i);
      Corner b = corners.get(i + 1);
      double length = Math.hypot(b.x() - a.x(), b.y() - a.y());
      if (length > longest) {
        longest = length;
        best = new Corner((a.x() + b.x()) / 2, (a.y() + b.y()) / 2);
      }
    }
    return best;
  }
}
