package org.robotui.message.ros.visualization_msgs;

import java.util.List;

import org.robotui.message.MessageType;
import org.robotui.message.ros.geometry_msgs.Pose;
import org.robotui.message.ros.std_msgs.Header;

/**
 * A marker that is moved by hand ({@code visualization_msgs/InteractiveMarker}).
 *
 * @param header time and frame
 * @param pose where it is
 * @param name unique at its server
 * @param description shown above it
 * @param scale size of the usual controls, metres
 * @param menuEntries its menu
 * @param controls how it is moved
 */
@MessageType("visualization_msgs/InteractiveMarker")
public record InteractiveMarker(
    Header header,
    Pose pose,
    String name,
    String description,
    float scale,
    List<MenuEntry> menuEntries,
    List<InteractiveMarkerControl> controls) {

  /** Keeps immutable copies of lists. */
  public InteractiveMarker {
    menuEntries = List.copyOf(menuEntries);
    controls = List.copyOf(controls);
  }
}
