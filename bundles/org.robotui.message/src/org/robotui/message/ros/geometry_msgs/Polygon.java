package org.robotui.message.ros.geometry_msgs;

import java.util.List;

import org.robotui.message.MessageType;

/**
 * A closed outline ({@code geometry_msgs/Polygon}).
 *
 * @param points its corners in order
 */
@MessageType("geometry_msgs/Polygon")
public record Polygon(List<Point32> points) {

  /** Keeps immutable copies of lists. */
  public Polygon {
    points = List.copyOf(points);
  }
}
