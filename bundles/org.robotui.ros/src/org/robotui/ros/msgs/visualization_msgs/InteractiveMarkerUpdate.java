package org.robotui.ros.msgs.visualization_msgs;

import java.util.List;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * What changed at a server of interactive markers ({@code visualization_msgs/InteractiveMarkerUpdate}).
 *
 * @param serverId of the server
 * @param seqNum   counts updates; a sign of life carries the number of the last one
 * @param type     update or sign of life
 * @param markers  new and changed ones
 * @param poses    of those that only moved
 * @param erases   names of those that are gone
 */
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

  /** Between records and bytes. */
  public static final RecordCodec<InteractiveMarkerUpdate> CODEC =
      RecordCodec.of("visualization_msgs/InteractiveMarkerUpdate", InteractiveMarkerUpdate::read, InteractiveMarkerUpdate::write);

  /** Keeps immutable copies of lists. */
  public InteractiveMarkerUpdate {
    markers = List.copyOf(markers);
    poses = List.copyOf(poses);
    erases = List.copyOf(erases);
  }

  private static InteractiveMarkerUpdate read(MessageReader in) throws MessageException {
    return new InteractiveMarkerUpdate(
        in.string("server_id"),
        in.int64("seq_num"),
        in.uint8("type"),
        in.list("markers", InteractiveMarker.CODEC),
        in.list("poses", InteractiveMarkerPose.CODEC),
        in.strings("erases"));
  }

  private static void write(InteractiveMarkerUpdate m, MessageWriter out) {
    out.string(m.serverId);
    out.i64(m.seqNum);
    out.u8(m.type);
    InteractiveMarker.CODEC.encodeAll(m.markers, out);
    InteractiveMarkerPose.CODEC.encodeAll(m.poses, out);
    out.array(m.erases.size());
    m.erases.forEach(out::string);
  }
}
