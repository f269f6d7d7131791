package org.robotui.ros.msgs.visualization_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.geometry_msgs.Point;
import org.robotui.ros.msgs.geometry_msgs.Pose;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * What a user does with an interactive marker ({@code visualization_msgs/InteractiveMarkerFeedback}).
 *
 * @param header          time and frame
 * @param clientId        who it is
 * @param markerName      which marker
 * @param controlName     which of its controls; may be empty
 * @param eventType       what was done
 * @param pose            where the user moved it
 * @param menuEntryId     what was chosen; 0 for nothing
 * @param mousePoint      what the pointer hit
 * @param mousePointValid whether that is so
 */
public record InteractiveMarkerFeedback(
    Header header,
    String clientId,
    String markerName,
    String controlName,
    int eventType,
    Pose pose,
    long menuEntryId,
    Point mousePoint,
    boolean mousePointValid) {

  /** The user still holds it. */
  public static final int KEEP_ALIVE = 0;
  /** It was moved. */
  public static final int POSE_UPDATE = 1;
  /** An entry of the menu was chosen. */
  public static final int MENU_SELECT = 2;
  /** It was clicked. */
  public static final int BUTTON_CLICK = 3;
  /** The button went down. */
  public static final int MOUSE_DOWN = 4;
  /** The button went up. */
  public static final int MOUSE_UP = 5;

  /** Between records and bytes. */
  public static final RecordCodec<InteractiveMarkerFeedback> CODEC =
      RecordCodec.of("visualization_msgs/InteractiveMarkerFeedback", InteractiveMarkerFeedback::read, InteractiveMarkerFeedback::write);

  private static InteractiveMarkerFeedback read(MessageReader in) throws MessageException {
    return new InteractiveMarkerFeedback(
        in.nested("header", Header.CODEC),
        in.string("client_id"),
        in.string("marker_name"),
        in.string("control_name"),
        in.uint8("event_type"),
        in.nested("pose", Pose.CODEC),
        in.uint32("menu_entry_id"),
        in.nested("mouse_point", Point.CODEC),
        in.bool("mouse_point_valid"));
  }

  private static void write(InteractiveMarkerFeedback m, MessageWriter out) {
    Header.CODEC.encode(m.header, out);
    out.string(m.clientId);
    out.string(m.markerName);
    out.string(m.controlName);
    out.u8(m.eventType);
    Pose.CODEC.encode(m.pose, out);
    out.i32((int) m.menuEntryId);
    Point.CODEC.encode(m.mousePoint, out);
    out.bool(m.mousePointValid);
  }
}
