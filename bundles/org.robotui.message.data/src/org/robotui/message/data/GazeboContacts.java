package org.robotui.message.data;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.robotui.data.FrameId;
import org.robotui.data.array.Bytes;
import org.robotui.data.array.Floats;
import org.robotui.data.marker.Color;
import org.robotui.data.marker.Marker;
import org.robotui.data.marker.MarkerSet;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;

/**
 * What touches in a world of Gazebo: a point at each place, and a line along its normal. A sensor is silent while
 * nothing touches, so that markers go by themselves.
 */
final class GazeboContacts {
  private static final long LIFETIME = Duration.ofMillis(300).toNanos();
  private static final Color COLOR = new Color(1, 0.35f, 0.2f, 1);
  private static final double POINT = 0.03;
  private static final double LINE = 0.01;
  private static final double LENGTH = 0.15;
  private static final String NAMESPACE = "contacts";

  private GazeboContacts() {}

  /** The places in the frame of the world that they name, else of their header. */
  static MarkerSet markers(NamedFields m, FrameNames names) {
    List<NamedFields> contacts = m.each("contact");
    FrameId frame = contacts.stream().map(each -> each.inner("world").text("name")).filter(name -> !name.isEmpty())
        .findFirst().map(names::frame).orElseGet(() -> GazeboAdapters.frame(m, names));
    float[] places = numbers(contacts.stream().flatMap(each -> each.each("position").stream())
        .map(GazeboContacts::vector).flatMap(GazeboContacts::coordinates));
    float[] normals = numbers(contacts.stream().flatMap(GazeboContacts::lines));
    return new MarkerSet(true, Stream.of(entry(0, frame, Marker.Type.SPHERE_LIST, POINT, places),
        entry(1, frame, Marker.Type.LINE_LIST, LINE, normals)).flatMap(Optional::stream).toList());
  }

  private static Stream<Float> lines(NamedFields contact) {
    List<NamedFields> places = contact.each("position");
    List<NamedFields> normals = contact.each("normal");
    return Stream.iterate(0, i -> i + 1).limit(Math.min(places.size(), normals.size())).flatMap(i -> {
      Vector3 from = vector(places.get(i));
      Vector3 along = vector(normals.get(i));
      return Stream.concat(coordinates(from), coordinates(from.plus(along.times(LENGTH))));
    });
  }

  private static Optional<MarkerSet.Entry> entry(int id, FrameId frame, Marker.Type type, double size,
      float[] points) {
    Marker.Key key = new Marker.Key(NAMESPACE, id);
    return points.length == 0 ? Optional.empty()
        : Optional.of(new MarkerSet.Entry(key, Optional.of(new Marker(key, frame, Optional.empty(), System.nanoTime(),
            type, RigidTransform.IDENTITY, new Vector3(size, size, size), COLOR, LIFETIME, true, Floats.wrap(points),
            Bytes.EMPTY, "", "", false))));
  }

  private static Vector3 vector(NamedFields m) {
    return Geometry.vector(FoxgloveTransforms.vector(m));
  }

  private static Stream<Float> coordinates(Vector3 v) {
    return Stream.of((float) v.x(), (float) v.y(), (float) v.z());
  }

  private static float[] numbers(Stream<Float> all) {
    List<Float> list = all.toList();
    float[] numbers = new float[list.size()];
    for (int i = 0; i < numbers.length; i++) {
      numbers[i] = list.get(i);
    }
    return numbers;
  }
}
