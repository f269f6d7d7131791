package org.robotui.message.ros.visualization_msgs;

import java.util.List;

import org.robotui.message.MessageType;

/**
 * Many markers at once ({@code visualization_msgs/MarkerArray}).
 *
 * @param markers in the order in which they count
 */
@MessageType("visualization_msgs/MarkerArray")
public record MarkerArray(List<Marker> markers) {

  /** Keeps immutable copies of lists. */
  public MarkerArray {
    markers = List.copyOf(markers);
  }
}
