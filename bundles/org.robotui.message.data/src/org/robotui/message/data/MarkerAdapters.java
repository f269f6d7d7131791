package org.robotui.message.data;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.data.Stamp;
import org.robotui.data.array.Bytes;
import org.robotui.data.array.Floats;
import org.robotui.data.marker.Color;
import org.robotui.data.marker.Marker;
import org.robotui.data.marker.MarkerSet;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.message.ros.geometry_msgs.Pose;
import org.robotui.message.ros.std_msgs.ColorRGBA;
import org.robotui.message.ros.visualization_msgs.MarkerArray;

/** Markers. Poses are taken as they are, since one bad marker must not hide the others of its message. */
final class MarkerAdapters {
  private static final int CHANNELS = 4;
  private static final Marker.Type[] TYPES = Marker.Type.values();

  private MarkerAdapters() {}

  /** In all their versions: the definition of markers has grown with rviz, and is found in old recordings. */
  static List<Adapter<?, ?>> all() {
    return List.of(
        Adapter.ofAnyVersion(org.robotui.message.ros.visualization_msgs.Marker.class, MarkerSet.class,
            (m, names) -> set(List.of(m), names),
            m -> m.header().stamp()),
        Adapter.ofAnyVersion(MarkerArray.class, MarkerSet.class, (m, names) -> set(m.markers(), names),
            m -> m.markers().isEmpty() ? 0 : m.markers().getFirst().header().stamp()));
  }

  private static MarkerSet set(List<org.robotui.message.ros.visualization_msgs.Marker> markers, FrameNames names) {
    boolean all = false;
    Map<Marker.Key, MarkerSet.Entry> entries = new LinkedHashMap<>();
    for (org.robotui.message.ros.visualization_msgs.Marker m : markers) {
      Marker.Key key = new Marker.Key(m.ns(), m.id());
      switch (m.action()) {
        case org.robotui.message.ros.visualization_msgs.Marker.ADD -> entries.put(key,
            new MarkerSet.Entry(key, Optional.of(marker(m, names))));
        case org.robotui.message.ros.visualization_msgs.Marker.DELETE -> entries.put(key,
            new MarkerSet.Entry(key, Optional.empty()));
        case org.robotui.message.ros.visualization_msgs.Marker.DELETEALL -> {
          all = true;
          entries.clear();
        }
        default -> throw new IllegalArgumentException(
            "marker " + key + ": action " + m.action() + " is none of 0, 2, 3");
      }
    }
    return new MarkerSet(all, List.copyOf(entries.values()));
  }

  static Marker marker(org.robotui.message.ros.visualization_msgs.Marker m, FrameNames names) {
    boolean known = m.type() >= 0 && m.type() < Marker.Type.UNKNOWN.ordinal();
    return new Marker(new Marker.Key(m.ns(), m.id()), names.frame(m.header().frameId()),
        stamp(m.header().stamp(), names),
        System.nanoTime(), known ? TYPES[m.type()] : Marker.Type.UNKNOWN, pose(m.pose()),
        new Vector3(m.scale().x(), m.scale().y(), m.scale().z()), color(m.color()), Math.max(0, m.lifetime()),
        m.frameLocked(),
        points(m.points()), colors(m), m.text(), m.meshResource(), m.meshUseEmbeddedMaterials());
  }

  static Optional<Stamp> stamp(long nanos, FrameNames names) {
    return nanos == 0 ? Optional.empty() : Optional.of(names.stamp(nanos));
  }

  /** As it was sent: without checks. */
  static RigidTransform pose(Pose p) {
    return new RigidTransform(new Vector3(p.position().x(), p.position().y(), p.position().z()),
        rotation(p.orientation()));
  }

  static Quaternion rotation(org.robotui.message.ros.geometry_msgs.Quaternion q) {
    return new Quaternion(q.x(), q.y(), q.z(), q.w());
  }

  private static Color color(ColorRGBA c) {
    return new Color(c.r(), c.g(), c.b(), c.a());
  }

  private static Floats points(double[] points) {
    float[] xyz = new float[points.length];
    for (int i = 0; i < xyz.length; i++) {
      xyz[i] = (float) points[i];
    }
    return xyz.length == 0 ? Floats.EMPTY : Floats.wrap(xyz);
  }

  /** A colour a point, or a triangle; any other number of colours counts as none, as with other viewers. */
  private static Bytes colors(org.robotui.message.ros.visualization_msgs.Marker m) {
    int points = m.points().length / 3;
    int colors = m.colors().length / CHANNELS;
    if (colors == 0) {
      return Bytes.EMPTY;
    }
    if (colors == points) {
      return bytes(m.colors(), 1);
    }
    boolean faces = m.type() == org.robotui.message.ros.visualization_msgs.Marker.TRIANGLE_LIST && 3 * colors == points;
    return faces ? bytes(m.colors(), 3) : Bytes.EMPTY;
  }

  private static Bytes bytes(float[] colors, int times) {
    byte[] rgba = new byte[colors.length * times];
    for (int i = 0; i < rgba.length; i++) {
      int from = i / (CHANNELS * times) * CHANNELS + i % CHANNELS;
      float value = colors[from];
      rgba[i] = (byte) Math.round(255 * (Float.isNaN(value) ? 0 : Math.clamp(value, 0, 1)));
    }
    return Bytes.wrap(rgba, 0, rgba.length);
  }
}
