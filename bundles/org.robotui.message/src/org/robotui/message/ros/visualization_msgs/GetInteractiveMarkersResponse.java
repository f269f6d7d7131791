package org.robotui.message.ros.visualization_msgs;

import java.util.List;

import org.robotui.message.MessageType;

/**
 * All interactive markers of a server of ROS 2 ({@code visualization_msgs/GetInteractiveMarkersResponse}).
 *
 * @param sequenceNumber number of the last update that is in it
 * @param markers all there are
 */
@MessageType("visualization_msgs/GetInteractiveMarkersResponse")
public record GetInteractiveMarkersResponse(long sequenceNumber, List<InteractiveMarker> markers) {

  /** Keeps immutable copies of lists. */
  public GetInteractiveMarkersResponse {
    markers = List.copyOf(markers);
  }
}
