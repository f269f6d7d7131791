package org.robotui.message.ros.visualization_msgs;

import java.util.List;

import org.robotui.message.MessageType;
import org.robotui.message.ros.geometry_msgs.Quaternion;

/**
 * How an interactive marker is moved by hand ({@code visualization_msgs/InteractiveMarkerControl}).
 *
 * @param name unique within the marker
 * @param orientation its x axis is the axis that is moved along or turned about, y and z span the plane
 * @param orientationMode what the orientation is relative to
 * @param interactionMode what dragging does
 * @param alwaysVisible whether it is seen also while nobody interacts
 * @param markers what is seen; empty for the usual look
 * @param independentMarkerOrientation whether the markers keep their orientation where the control faces the viewer
 * @param description a hint for users
 */
@MessageType("visualization_msgs/InteractiveMarkerControl")
public record InteractiveMarkerControl(
    String name,
    Quaternion orientation,
    int orientationMode,
    int interactionMode,
    boolean alwaysVisible,
    List<Marker> markers,
    boolean independentMarkerOrientation,
    String description) {

  /** Turns with the marker. */
  public static final int INHERIT = 0;
  /** Stays as it is. */
  public static final int FIXED = 1;
  /** Faces the viewer. */
  public static final int VIEW_FACING = 2;
  /** Nothing. */
  public static final int NONE = 0;
  /** Opens the menu. */
  public static final int MENU = 1;
  /** Is clicked. */
  public static final int BUTTON = 2;
  /** Moves along the axis. */
  public static final int MOVE_AXIS = 3;
  /** Moves in the plane. */
  public static final int MOVE_PLANE = 4;
  /** Turns about the axis. */
  public static final int ROTATE_AXIS = 5;
  /** Moves in the plane and turns. */
  public static final int MOVE_ROTATE = 6;
  /** Moves in space. */
  public static final int MOVE_3D = 7;
  /** Turns in space. */
  public static final int ROTATE_3D = 8;
  /** Moves and turns in space. */
  public static final int MOVE_ROTATE_3D = 9;

  /** Keeps immutable copies of lists. */
  public InteractiveMarkerControl {
    markers = List.copyOf(markers);
  }
}
