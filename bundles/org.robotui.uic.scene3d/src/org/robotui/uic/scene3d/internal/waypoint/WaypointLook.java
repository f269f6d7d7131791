package org.robotui.uic.scene3d.internal.waypoint;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.shape.Describer;
import org.robotui.gl.shape.Handle;
import org.robotui.gl.shape.Label;
import org.robotui.gl.shape.LineSet;
import org.robotui.gl.shape.Material;
import org.robotui.gl.shape.Meshes;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.Placings;
import org.robotui.gl.shape.PointSet;
import org.robotui.gl.shape.Properties;
import org.robotui.gl.shape.Rgba;
import org.robotui.gl.shape.Shape;

/**
 * How waypoints look: a disc with an arrow and a number each, and a line through all. Shapes stay the same objects
 * while they look the same.
 */
final class WaypointLook {
  private static final Rgba COLOR = Rgba.of(0xb07cff);
  private static final Rgba AHEAD = Rgba.of(0x3ecf8e);
  private static final float LETTERS = 15;
  private static final float WIDTH = 2.5f;
  private static final double LIFT = 0.02;
  private static final double FLAT = 0.05;
  private static final double ABOVE = 0.6;

  private final List<Label> numbers = new ArrayList<>();
  private double size;
  private Shape disc = Meshes.disc();
  private Shape arrow = Meshes.arrow();
  private List<RigidTransform> poses = List.of();
  private LineSet line = LineSet.of(LineSet.Kind.STRIP, WIDTH);

  /** Gives the handle of a waypoint. */
  @FunctionalInterface
  interface Handles {
    /** The handle that moves, or turns, the waypoint of an index. */
    Handle of(int index, boolean turns);
  }

  /** What a part is of; the number is that of the waypoint, from 0. */
  record Key(String what, int index) {}

  List<Part> parts(Route route, RigidTransform fixedFromFrame, double wanted, OptionalInt driving, Handles handles) {
    prepare(route, wanted);
    List<Part> parts = new ArrayList<>();
    RigidTransform lift = new RigidTransform(new Vector3(0, 0, LIFT), Quaternion.IDENTITY);
    RigidTransform above = new RigidTransform(new Vector3(0, 0, ABOVE * size), Quaternion.IDENTITY);
    for (int i = 0; i < poses.size(); i++) {
      RigidTransform at = fixedFromFrame.times(poses.get(i));
      Rgba color = driving.isPresent() && driving.getAsInt() == i ? AHEAD : COLOR;
      Describer words = describer(route, i);
      parts.add(new Part(new Key("disc", i), disc, at.times(lift), Material.lit(color.withAlpha(0.75)), words,
          Optional.of(handles.of(i, false))));
      parts.add(new Part(new Key("arrow", i), arrow, at.times(lift), Material.lit(color), words,
          Optional.of(handles.of(i, true))));
      parts.add(new Part(new Key("number", i), numbers.get(i), at.times(above), Material.flat(color).onTop(), words));
    }
    if (poses.size() > 1) {
      parts.add(new Part(new Key("line", 0), line, fixedFromFrame.times(lift), Material.flat(COLOR),
          Describer.of("Path through the waypoints")));
    }
    return parts;
  }

  private void prepare(Route route, double wanted) {
    if (wanted != size) {
      size = wanted;
      disc = new Placings(1).add(RigidTransform.IDENTITY, new Vector3(size, size, FLAT * size)).of(Meshes.cylinder());
      // The arrow begins at the rim of the disc, so that both can be gripped.
      arrow = new Placings(1)
          .add(new RigidTransform(new Vector3(size / 2, 0, 0), Quaternion.IDENTITY),
              new Vector3(size, 0.4 * size, 0.4 * size))
          .of(Meshes.arrow());
    }
    while (numbers.size() < route.poses().size()) {
      numbers.add(new Label(Integer.toString(numbers.size() + 1), LETTERS, PointSet.Unit.PIXELS));
    }
    if (!route.poses().equals(poses)) {
      poses = route.poses();
      line = LineSet.of(LineSet.Kind.STRIP, WIDTH, poses.stream().map(RigidTransform::translation).toList());
    }
  }

  private static Describer describer(Route route, int index) {
    RigidTransform pose = route.poses().get(index);
    String place = String.format(Locale.ROOT, "%.3f, %.3f, %.3f m", pose.translation().x(), pose.translation().y(),
        pose.translation().z());
    String yaw = String.format(Locale.ROOT, "%.1f\u00b0", Math.toDegrees(pose.rotation().yaw()));
    return (element, hit) -> Properties.of("Waypoint " + (index + 1) + " of " + route.poses().size(),
        new Properties.Entry("Frame", route.frame().map(f -> f.name()).orElse("")),
        new Properties.Entry("Place", place),
        new Properties.Entry("Heading", yaw));
  }
}
