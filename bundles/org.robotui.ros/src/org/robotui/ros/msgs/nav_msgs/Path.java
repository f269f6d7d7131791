package org.robotui.ros.msgs.nav_msgs;

import java.util.List;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.geometry_msgs.PoseStamped;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * Poses to follow or followed ({@code nav_msgs/Path}).
 *
 * @param header time and frame
 * @param poses  in order
 */
public record Path(Header header, List<PoseStamped> poses) {

  /** Between records and bytes. */
  public static final RecordCodec<Path> CODEC =
      RecordCodec.of("nav_msgs/Path", Path::read, Path::write);

  /** Keeps immutable copies of lists. */
  public Path {
    poses = List.copyOf(poses);
  }

  private static Path read(MessageReader in) throws MessageException {
    return new Path(in.nested("header", Header.CODEC), in.list("poses", PoseStamped.CODEC));
  }

  private static void write(Path m, MessageWriter out) {
    Header.CODEC.encode(m.header, out);
    PoseStamped.CODEC.encodeAll(m.poses, out);
  }
}
