package org.robotui.sim.internal.message;

import java.util.ArrayList;
import java.util.List;
import org.robotui.message.ros.geometry_msgs.Point;
import org.robotui.message.ros.geometry_msgs.Pose;
import org.robotui.message.ros.geometry_msgs.Vector3;
import org.robotui.message.ros.std_msgs.ColorRGBA;
import org.robotui.message.ros.std_msgs.Header;
import org.robotui.message.ros.visualization_msgs.Marker;
import org.robotui.message.ros.visualization_msgs.MarkerArray;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.world.Pose2;
import org.robotui.sim.internal.world.Thing;
import org.robotui.sim.internal.world.World;

/**
 * What stands around, as something that recognises objects would say it: boxes, cylinders, their names, and who walks
 * by.
 */
final class ObjectMarkers {
  private static final double LETTERS = 0.16;
  private static final float GLASS = 0.45f;
  private static final long SECOND = 1_000_000_000L;
  private static final int COAT = 0x5b4a8a;
  private static final double PERSON_HEIGHT = 1.72;
  private static final double PERSON_WIDTH = 0.4;

  private final List<Marker> things = new ArrayList<>();

  ObjectMarkers(World world) {
    Header map = new Header(0, 0, Frames.MAP);
    List<Thing> all = world.things();
    for (int i = 0; i < all.size(); i++) {
      Thing t = all.get(i);
      things.add(body(map, "objects", i, t.round() ? Marker.CYLINDER : Marker.CUBE, new Pose2(t.x(), t.y(), 0),
          new Vector3(t.width(), t.depth(), t.height()), t.colour(), 0));
      things.add(name(map, i, new Pose2(t.x(), t.y(), 0), t.height(), t.name().replace('_', ' '), 0));
    }
  }

  /** Somebody who walks goes by itself where nothing more is heard. */
  MarkerArray message(RobotState state, Stamp stamp) {
    List<Marker> all = new ArrayList<>(things);
    state.person().ifPresent(place -> {
      Header map = stamp.header(Frames.MAP);
      all.add(body(map, "people", 0, Marker.CYLINDER, place, new Vector3(PERSON_WIDTH, PERSON_WIDTH, PERSON_HEIGHT),
          COAT, 2 * SECOND));
      all.add(name(map, things.size(), place, PERSON_HEIGHT, "person", 2 * SECOND));
    });
    return new MarkerArray(all);
  }

  private static Marker body(Header header, String namespace, int id, int type, Pose2 place, Vector3 size, int colour,
      long lifetime) {
    ColorRGBA paint =
        new ColorRGBA((colour >> 16 & 0xff) / 255f, (colour >> 8 & 0xff) / 255f, (colour & 0xff) / 255f, GLASS);
    return marker(header, namespace, id, type, at(place, size.z() / 2), size, paint, lifetime, "");
  }

  private static Marker name(Header header, int id, Pose2 place, double height, String text, long lifetime) {
    return marker(header, "names", id, Marker.TEXT_VIEW_FACING, at(place, height + LETTERS), new Vector3(0, 0, LETTERS),
        new ColorRGBA(1, 1, 1, 1), lifetime, text);
  }

  private static Pose at(Pose2 place, double height) {
    return new Pose(new Point(place.x(), place.y(), height), Poses.yaw(place.yaw()));
  }

  private static Marker marker(Header header, String namespace, int id, int type, Pose pose, Vector3 size,
      ColorRGBA paint, long lifetime, String text) {
    return new Marker(header, namespace, id, type, Marker.ADD, pose, size, paint, lifetime, false, new double[0],
        new float[0], text, "", false);
  }
}
