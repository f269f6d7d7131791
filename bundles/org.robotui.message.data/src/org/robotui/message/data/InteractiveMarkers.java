package org.robotui.message.data;

import java.util.Optional;
import org.robotui.data.marker.InteractiveMarker;
import org.robotui.data.marker.MarkerFeedback;
import org.robotui.geometry.Vector3;
import org.robotui.message.ros.geometry_msgs.Point;
import org.robotui.message.ros.std_msgs.Header;
import org.robotui.message.ros.visualization_msgs.InteractiveMarkerControl;
import org.robotui.message.ros.visualization_msgs.InteractiveMarkerFeedback;
import org.robotui.message.ros.visualization_msgs.InteractiveMarkerPose;
import org.robotui.message.ros.visualization_msgs.MenuEntry;

/** Interactive markers and what users do with them. */
public final class InteractiveMarkers {
  private InteractiveMarkers() {}

  /**
   * Converts a marker.
   *
   * @param m the message
   * @param feedback where its server listens
   * @param names names frames of the robot
   * @return the marker
   * @throws IllegalArgumentException where a mode is none
   */
  public static InteractiveMarker marker(
      org.robotui.message.ros.visualization_msgs.InteractiveMarker m, String feedback, FrameNames names) {
    return new InteractiveMarker(m.name(), m.description(), feedback, names.frame(m.header().frameId()),
        MarkerAdapters.stamp(m.header().stamp(), names), MarkerAdapters.pose(m.pose()), m.scale(),
        m.menuEntries().stream().map(InteractiveMarkers::entry).toList(),
        m.controls().stream().map(c -> control(m.name(), c, names)).toList());
  }

  /**
   * Moves a marker.
   *
   * @param marker as it was
   * @param m where it is now
   * @param names names frames of the robot
   * @return the moved marker
   */
  public static InteractiveMarker moved(InteractiveMarker marker, InteractiveMarkerPose m, FrameNames names) {
    return marker.at(names.frame(m.header().frameId()), MarkerAdapters.stamp(m.header().stamp(), names),
        MarkerAdapters.pose(m.pose()));
  }

  /**
   * Makes a message of what a user did.
   *
   * @param f what was done
   * @param client names this program among others that handle the same marker
   * @return the message
   */
  public static InteractiveMarkerFeedback feedback(MarkerFeedback f, String client) {
    Header header = new Header(0, f.stamp().map(org.robotui.data.Stamp::nanos).orElse(0L), f.frame().name());
    Vector3 p = f.point().orElse(Vector3.ZERO);
    return new InteractiveMarkerFeedback(header, client + "/" + f.client(), f.marker(), f.control(),
        f.event().ordinal(),
        Geometry.pose(f.pose()), f.menuEntry(), new Point(p.x(), p.y(), p.z()), f.point().isPresent());
  }

  private static InteractiveMarker.MenuEntry entry(MenuEntry e) {
    return new InteractiveMarker.MenuEntry((int) e.id(), (int) e.parentId(), e.title());
  }

  private static InteractiveMarker.Control control(String marker, InteractiveMarkerControl c, FrameNames names) {
    String what = "interactive marker " + marker + ", control " + c.name();
    return new InteractiveMarker.Control(c.name(), c.description(),
        one(InteractiveMarker.Mode.values(), c.interactionMode(), what + ": mode"),
        one(InteractiveMarker.Orientation.values(), c.orientationMode(), what + ": orientation mode"),
        MarkerAdapters.rotation(c.orientation()), c.alwaysVisible(),
        c.markers().stream().map(m -> MarkerAdapters.marker(m, names)).toList(), c.independentMarkerOrientation());
  }

  private static <E> E one(E[] values, int index, String what) {
    return Optional.of(index).filter(i -> i >= 0 && i < values.length).map(i -> values[i])
        .orElseThrow(() -> new IllegalArgumentException(what + " " + index + " is not known"));
  }
}
