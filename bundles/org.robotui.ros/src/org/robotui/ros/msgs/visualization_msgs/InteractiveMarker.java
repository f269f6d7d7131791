package org.robotui.ros.msgs.visualization_msgs;

import java.util.List;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.geometry_msgs.Pose;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * A marker that is moved by hand ({@code visualization_msgs/InteractiveMarker}).
 *
 * @param header      time and frame
 * @param pose        where it is
 * @param name        unique at its server
 * @param description shown above it
 * @param scale       size of the usual controls, metres
 * @param menuEntries its menu
 * @param controls    how it is moved
 */
public record InteractiveMarker(
    Header header,
    Pose pose,
    String name,
    String description,
    float scale,
    List<MenuEntry> menuEntries,
    List<InteractiveMarkerControl> controls) {

  /** Between records and bytes. */
  public static final RecordCodec<InteractiveMarker> CODEC =
      RecordCodec.of("visualization_msgs/InteractiveMarker", InteractiveMarker::read, InteractiveMarker::write);

  /** Keeps immutable copies of lists. */
  public InteractiveMarker {
    menuEntries = List.copyOf(menuEntries);
    controls = List.copyOf(controls);
  }

  private static InteractiveMarker read(MessageReader in) throws MessageException {
    return new InteractiveMarker(
        in.nested("header", Header.CODEC),
        in.nested("pose", Pose.CODEC),
        in.string("name"),
        in.string("description"),
        in.float32("scale"),
        in.list("menu_entries", MenuEntry.CODEC),
        in.list("controls", InteractiveMarkerControl.CODEC));
  }

  private static void write(InteractiveMarker m, MessageWriter out) {
    Header.CODEC.encode(m.header, out);
    Pose.CODEC.encode(m.pose, out);
    out.string(m.name);
    out.string(m.description);
    out.f32(m.scale);
    MenuEntry.CODEC.encodeAll(m.menuEntries, out);
    InteractiveMarkerControl.CODEC.encodeAll(m.controls, out);
  }
}
