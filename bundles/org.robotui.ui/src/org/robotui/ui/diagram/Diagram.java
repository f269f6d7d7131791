package org.robotui.ui.diagram;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * Boxes and wires at their places.
 *
 * @param boxes in the order in which they are painted; groups before what lies in them
 * @param wires painted below all boxes but groups
 * @param width of all of it
 * @param height of all of it
 */
public record Diagram(List<Box> boxes, List<Wire> wires, double width, double height) {
  /** Without anything. */
  public static final Diagram EMPTY = new Diagram(List.of(), List.of(), 0, 0);

  /**
   * Copies the lists.
   *
   * @param boxes in the order of painting
   * @param wires between them
   * @param width of all
   * @param height of all
   */
  public Diagram {
    boxes = List.copyOf(boxes);
    wires = List.copyOf(wires);
  }

  /**
   * The box at a place; what lies in a group comes before the group.
   *
   * @param x points from the left
   * @param y points from the top
   * @return the box, or none
   */
  public Optional<Box> at(double x, double y) {
    return boxes.reversed().stream().filter(box -> box.contains(x, y)).findFirst();
  }

  /**
   * A box by its key.
   *
   * @param key the key
   * @return the box, or none
   */
  public Optional<Box> find(Object key) {
    return boxes.stream().filter(box -> box.key().equals(key)).findFirst();
  }

  /**
   * What hangs together with a box directly.
   *
   * @param key of the box
   * @return its key and those of the boxes at the other ends of its wires
   */
  public Set<Object> around(Object key) {
    Set<Object> keys = new HashSet<>(Set.of(key));
    for (Wire wire : wires) {
      if (wire.from().equals(key)) {
        keys.add(wire.to());
      } else if (wire.to().equals(key)) {
        keys.add(wire.from());
      }
    }
    return keys;
  }
}
