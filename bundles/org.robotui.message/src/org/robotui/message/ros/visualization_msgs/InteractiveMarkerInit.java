package org.robotui.message.ros.visualization_msgs;

import java.util.List;

import org.robotui.message.MessageType;

/**
 * All interactive markers of a server ({@code visualization_msgs/InteractiveMarkerInit}).
 *
 * @param serverId of the server
 * @param seqNum number of the last update that is in it
 * @param markers all there are
 */
@MessageType("visualization_msgs/InteractiveMarkerInit")
public record InteractiveMarkerInit(String serverId, long seqNum, List<InteractiveMarker> markers) {

  /** Keeps immutable copies of lists. */
  public InteractiveMarkerInit {
    markers = List.copyOf(markers);
  }
}
