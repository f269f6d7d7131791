package org.robotui.ros.msgs.visualization_msgs;

import java.util.List;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * Many markers at once ({@code visualization_msgs/MarkerArray}).
 *
 * @param markers in the order in which they count
 */
public record MarkerArray(List<Marker> markers) {

  /** Between records and bytes. */
  public static final RecordCodec<MarkerArray> CODEC =
      RecordCodec.of("visualization_msgs/MarkerArray", MarkerArray::read, MarkerArray::write);

  /** Keeps immutable copies of lists. */
  public MarkerArray {
    markers = List.copyOf(markers);
  }

  private static MarkerArray read(MessageReader in) throws MessageException {
    return new MarkerArray(in.list("markers", Marker.CODEC));
  }

  private static void write(MarkerArray m, MessageWriter out) {
    Marker.CODEC.encodeAll(m.markers, out);
  }
}
