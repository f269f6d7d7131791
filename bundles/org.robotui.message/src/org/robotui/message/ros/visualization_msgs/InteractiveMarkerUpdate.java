package org.robotui.message.ros.visualization_msgs;

import java.util.List;

import org.robotui.message.MessageType;

/**
 * What changed at a server of interactive markers ({@code visualization_msgs/InteractiveMarkerUpdate}).
 *
 * @param serverId of the server
 * @param seqNum counts updates; a sign of life carries the number of the last one
 * @param type update or sign of life
 * @param markers new and changed ones
 * @param poses of those that only moved
 * @param erases names of those that are gone
 */
@MessageType("visualization_msgs/InteractiveMarkerUpdate")
public record InteractiveMarkerUpdate(
    String serverId,
    long seqNum,
    int type,
    List<InteractiveMarker> markers,
    List<InteractiveMarkerPose> poses,
    List<String> erases) {

  /** A sign of life. */
  public static final int KEEP_ALIVE = 0;
  /** Something changed. */
  public static final int UPDATE = 1;

  /** Keeps immutable copies of lists. */
  public InteractiveMarkerUpdate {
    markers = List.copyOf(markers);
    poses = List.copyOf(poses);
    erases = List.copyOf(erases);
  }
}
