package org.robotui.message.ros.visualization_msgs;

import org.robotui.message.MessageType;
import org.robotui.message.ros.geometry_msgs.Point;
import org.robotui.message.ros.geometry_msgs.Pose;
import org.robotui.message.ros.std_msgs.Header;

/**
 * What a user does with an interactive marker ({@code visualization_msgs/InteractiveMarkerFeedback}).
 *
 * @param header time and frame
 * @param clientId who it is
 * @param markerName which marker
 * @param controlName which of its controls; may be empty
 * @param eventType what was done
 * @param pose where the user moved it
 * @param menuEntryId what was chosen; 0 for nothing
 * @param mousePoint what the pointer hit
 * @param mousePointValid whether that is so
 */
@MessageType("visualization_msgs/InteractiveMarkerFeedback")
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
}
