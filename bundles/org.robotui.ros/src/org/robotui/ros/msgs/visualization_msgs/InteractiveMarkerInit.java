package org.robotui.ros.msgs.visualization_msgs;

import java.util.List;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * All interactive markers of a server ({@code visualization_msgs/InteractiveMarkerInit}).
 *
 * @param serverId of the server
 * @param seqNum   number of the last update that is in it
 * @param markers  all there are
 */
public record InteractiveMarkerInit(String serverId, long seqNum, List<InteractiveMarker> markers) {

  /** Between records and bytes. */
  public static final RecordCodec<InteractiveMarkerInit> CODEC =
      RecordCodec.of("visualization_msgs/InteractiveMarkerInit", InteractiveMarkerInit::read, InteractiveMarkerInit::write);

  /** Keeps immutable copies of lists. */
  public InteractiveMarkerInit {
    markers = List.copyOf(markers);
  }

  private static InteractiveMarkerInit read(MessageReader in) throws MessageException {
    return new InteractiveMarkerInit(
        in.string("server_id"),
        in.int64("seq_num"),
        in.list("markers", InteractiveMarker.CODEC));
  }

  private static void write(InteractiveMarkerInit m, MessageWriter out) {
    out.string(m.serverId);
    out.i64(m.seqNum);
    InteractiveMarker.CODEC.encodeAll(m.markers, out);
  }
}
