package org.robotui.message.topic.internal;

import java.util.List;
import org.robotui.message.ros.geometry_msgs.Point;
import org.robotui.message.ros.geometry_msgs.Pose;
import org.robotui.message.ros.geometry_msgs.Quaternion;
import org.robotui.message.ros.std_msgs.Header;
import org.robotui.message.ros.visualization_msgs.InteractiveMarker;
import org.robotui.message.ros.visualization_msgs.MenuEntry;

/** Interactive markers for tests. */
public final class SampleHandles {
  private SampleHandles() {}

  static Pose pose(double x, double y, double z) {
    return new Pose(new Point(x, y, z), new Quaternion(0, 0, 0, 1));
  }

  /** A marker with a menu, that many metres along the x axis. */
  public static InteractiveMarker interactive(String name, double x) {
    return new InteractiveMarker(new Header(0, 0, "map"), pose(x, 0, 0), name, "the " + name, 1,
        List.of(new MenuEntry(1, 0, "Go", "", 0)), List.of());
  }
}
