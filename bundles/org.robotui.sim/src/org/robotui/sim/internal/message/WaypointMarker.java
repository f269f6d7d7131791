package org.robotui.sim.internal.message;

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
import org.robotui.sim.internal.world.Pose2;

/** What the waypoint looks like: an arrow on a disc that moves and turns on the floor, and a menu. */
final class WaypointMarker {
  static final String NAME = "waypoint";
  static final int GO = 1;
  static final int TO_ROBOT = 2;
  private static final double HALF = Math.sqrt(0.5);
  private static final ColorRGBA ORANGE = new ColorRGBA(0.95f, 0.55f, 0.15f, 0.9f);
  private static final ColorRGBA PALE = new ColorRGBA(0.95f, 0.55f, 0.15f, 0.45f);
  private static final Quaternion UP = new Quaternion(0, -HALF, 0, HALF);

  private WaypointMarker() {}

  static InteractiveMarker message(Pose2 place) {
    List<MenuEntry> menu = List.of(new MenuEntry(GO, 0, "Go", "", MenuEntry.FEEDBACK),
        new MenuEntry(TO_ROBOT, 0, "Back to the robot", "", MenuEntry.FEEDBACK));
    List<InteractiveMarkerControl> controls = List.of(
        control("floor", UP, InteractiveMarkerControl.MOVE_ROTATE, List.of(disc(), arrow())),
        control("along", new Quaternion(0, 0, 0, 1), InteractiveMarkerControl.MOVE_AXIS, List.of()),
        control("across", new Quaternion(0, 0, HALF, HALF), InteractiveMarkerControl.MOVE_AXIS, List.of()),
        control("menu", new Quaternion(0, 0, 0, 1), InteractiveMarkerControl.MENU, List.of(knob())));
    return new InteractiveMarker(new Header(0, 0, Frames.MAP), Poses.pose(place), NAME, "Waypoint", 0.8f, menu,
        controls);
  }

  private static InteractiveMarkerControl control(String name, Quaternion turn, int mode, List<Marker> look) {
    return new InteractiveMarkerControl(name, turn, InteractiveMarkerControl.INHERIT, mode, true, look, false, "");
  }

  private static Marker disc() {
    return marker(Marker.CYLINDER, new Point(0, 0, 0.02), new Vector3(0.6, 0.6, 0.04), PALE);
  }

  private static Marker arrow() {
    return marker(Marker.ARROW, new Point(-0.25, 0, 0.1), new Vector3(0.5, 0.1, 0.1), ORANGE);
  }

  private static Marker knob() {
    return marker(Marker.SPHERE, new Point(0, 0, 0.4), new Vector3(0.14, 0.14, 0.14), ORANGE);
  }

  private static Marker marker(int type, Point place, Vector3 size, ColorRGBA colour) {
    Pose pose = new Pose(place, new Quaternion(0, 0, 0, 1));
    return new Marker(new Header(0, 0, ""), "", 0, type, Marker.ADD, pose, size, colour, 0, false, new double[0],
        new float[0], "", "", false);
  }
}
