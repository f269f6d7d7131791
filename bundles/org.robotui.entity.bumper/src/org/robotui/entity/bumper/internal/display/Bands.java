package org.robotui.entity.bumper.internal.display;

import java.util.ArrayList;
import java.util.List;
import org.robotui.data.sensor.Bumper;
import org.robotui.data.sensor.Bumpers;
import org.robotui.entity.bumper.internal.Rim;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.shape.Instances;
import org.robotui.gl.shape.Meshes;
import org.robotui.gl.shape.Placings;
import org.robotui.gl.shape.Rgba;

/** Bumpers as bands of boxes, in the frame of the bumpers. */
final class Bands {
  static final int MOST = 256;
  private static final double THICK = 0.015;
  private static final double THICKER = 0.03;

  private final Instances shape;
  private final List<Integer> owners;
  private final int bumpers;

  private Bands(Instances shape, List<Integer> owners, int bumpers) {
    this.shape = shape;
    this.owners = List.copyOf(owners);
    this.bumpers = bumpers;
  }

  /** The settings that bands depend on. */
  record Look(Rgba free, Rgba pressed, double height) {}

  /** A box of a band. */
  private record Box(int bumper, RigidTransform at, double length, boolean pressed) {}

  static Bands of(Bumpers all, Look look) {
    List<Box> boxes = new ArrayList<>();
    int drawn = 0;
    for (int i = 0; i < Math.min(all.bumpers().size(), MOST); i++) {
      drawn += add(i, all.bumpers().get(i), boxes) ? 1 : 0;
    }
    Placings placings = new Placings(boxes.size());
    boxes.forEach(
        box -> placings.add(box.at(), new Vector3(box.length(), box.pressed() ? THICKER : THICK, look.height()),
            box.pressed() ? look.pressed() : look.free()));
    return new Bands(placings.of(Meshes.cube()), boxes.stream().map(Box::bumper).toList(), drawn);
  }

  Instances shape() {
    return shape;
  }

  /** How many boxes. */
  int count() {
    return owners.size();
  }

  /** How many bumpers they are of. */
  int bumpers() {
    return bumpers;
  }

  /** Whose a box is. */
  int bumper(int box) {
    return owners.get(box);
  }

  private static boolean add(int index, Bumper bumper, List<Box> boxes) {
    List<Vector3> points = Rim.of(bumper);
    boolean sound = bumper.pose().translation().isFinite() && Double.isFinite(bumper.pose().rotation().norm());
    for (int i = 1; sound && i < points.size(); i++) {
      boxes.add(box(index, bumper, points.get(i - 1), points.get(i)));
    }
    return sound && !points.isEmpty();
  }

  /** Its x axis lies along the band; those of a bend overlap, so that no gap is seen. */
  private static Box box(int index, Bumper bumper, Vector3 from, Vector3 to) {
    Vector3 along = to.minus(from);
    RigidTransform at =
        RigidTransform.planar((from.x() + to.x()) / 2, (from.y() + to.y()) / 2, Math.atan2(along.y(), along.x()));
    return new Box(index, bumper.pose().times(at), along.norm() + (bumper.radius() > 0 ? THICK / 2 : 0),
        bumper.pressed());
  }
}
