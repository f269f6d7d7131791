package org.robotui.gl.internal.scene;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import org.robotui.gl.internal.draw.Camera;
import org.robotui.gl.shape.Box3;
import org.robotui.gl.shape.Label;
import org.robotui.gl.shape.PointSet;
import org.robotui.gl.shape.PointSet.Unit;
import org.robotui.gl.shape.TriangleMesh;

/**
 * What is seen, in the order in which it is drawn: what is opaque from the front to the back, so that what is hidden is
 * not computed; then what is translucent from the back to the front.
 *
 * @param opaque from the front
 * @param translucent from the back
 */
record Order(List<Resident> opaque, List<Resident> translucent) {
  private record Seen(Resident resident, double depth) {}

  static Order of(Collection<Resident> residents, Camera camera) {
    List<Seen> opaque = new ArrayList<>();
    List<Seen> translucent = new ArrayList<>();
    for (Resident resident : residents) {
      resident.part().bounds().filter(box -> sees(camera, resident, box)).ifPresent(
          box -> (resident.translucent() ? translucent : opaque).add(new Seen(resident, camera.depth(box.center()))));
    }
    return new Order(sorted(opaque, Comparator.comparingDouble(Seen::depth)),
        sorted(translucent, Comparator.comparingDouble(Seen::depth).reversed()));
  }

  private static List<Resident> sorted(List<Seen> seen, Comparator<Seen> by) {
    return seen.stream().sorted(by).map(Seen::resident).toList();
  }

  /** Words reach farther than their place, by how much is seen only when they are drawn. */
  private static boolean sees(Camera camera, Resident resident, Box3 box) {
    return switch (resident.part().shape()) {
      case Label label -> true;
      case PointSet points when points.unit() == Unit.METRES -> camera.sees(box.grown(points.size()));
      default -> camera.sees(box);
    };
  }

  /** How many points there are to draw. */
  long points() {
    return points(opaque) + points(translucent);
  }

  /** How many triangles of meshes there are to draw. */
  long triangles() {
    return Stream.concat(opaque.stream(), translucent.stream())
        .mapToLong(resident -> resident.part().shape() instanceof TriangleMesh mesh ? mesh.elements() : 0).sum();
  }

  private static long points(List<Resident> residents) {
    return residents.stream()
        .mapToLong(resident -> resident.part().shape() instanceof PointSet points ? points.elements() : 0).sum();
  }
}
