package org.robotui.message.data;

import java.util.List;
import org.robotui.message.ros.geometry_msgs.Point;
import org.robotui.message.ros.geometry_msgs.Pose;
import org.robotui.message.ros.geometry_msgs.Quaternion;
import org.robotui.message.ros.geometry_msgs.Vector3;
import org.robotui.message.ros.std_msgs.ColorRGBA;
import org.robotui.message.ros.std_msgs.Header;
import org.robotui.message.ros.visualization_msgs.InteractiveMarker;
import org.robotui.message.ros.visualization_msgs.InteractiveMarkerControl;
import org.robotui.message.ros.visualization_msgs.Marker;
import org.robotui.message.ros.visualization_msgs.MenuEntry;

/** Messages for tests. */
public final class SampleMarkers {
  private SampleMarkers() {}

  static Marker marker(String namespace, int id, int type, int action, double[] points, float[] colors) {
    return new Marker(new Header(0, 5_000_000_000L, "map"), namespace, id, type, action, pose(1, 2, 3),
        new Vector3(0.1, 0.2, 0.3),
        new ColorRGBA(1, 0.5f, 0, 1), 2_000_000_000L, true, points, colors, "a text", "package://p/a.dae", true);
  }

  /**
   * A place.
   *
   * @param x metres
   * @param y metres
   * @param z metres
   * @return the pose without rotation
   */
  public static Pose pose(double x, double y, double z) {
    return new Pose(new Point(x, y, z), new Quaternion(0, 0, 0, 1));
  }

  /**
   * A marker that is moved along its x axis and has a menu.
   *
   * @param name of the marker
   * @param x where it is, metres
   * @return the message
   */
  public static InteractiveMarker interactive(String name, double x) {
    InteractiveMarkerControl control = new InteractiveMarkerControl("along", new Quaternion(0, 0, 0, 1), 0, 3, false,
        List.of(marker("", 0, Marker.CUBE, 0, new double[0], new float[0])), false, "drag it");
    return new InteractiveMarker(new Header(0, 0, "map"), pose(x, 0, 0), name, "the " + name, 1,
        List.of(new MenuEntry(1, 0, "Go", "", 0)), List.of(control));
  }
}
