package org.robotui.gl.shape;

import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.util.Optional;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;

/**
 * One mesh many times: arrows of poses, cubes and spheres of marker lists.
 *
 * @param mesh what is repeated
 * @param placings ten numbers each: x, y, z; the unit quaternion x, y, z, w; the scale along the mesh's x, y, z
 * @param rgba four bytes red, green, blue, alpha each; empty where the material colours all
 * @param bounds where they lie
 */
public record Instances(TriangleMesh mesh, FloatBuffer placings, Optional<ByteBuffer> rgba, Optional<Box3> bounds)
    implements Shape {
  /** Numbers of one placing. */
  public static final int PLACING = 10;

  /**
   * Checks the sizes.
   *
   * @param mesh what is repeated
   * @param placings where
   * @param rgba their colours
   * @param bounds where they lie
   */
  public Instances {
    placings = placings.slice();
    if (placings.remaining() % PLACING != 0) {
      throw new IllegalArgumentException("placings: " + placings.remaining() + " numbers, must be ten each");
    }
    rgba = rgba.map(ByteBuffer::slice);
    int count = placings.remaining() / PLACING;
    rgba.ifPresent(colors -> Colors.fit(colors, count));
  }

  /**
   * A mesh many times, with its bounds computed: a box around the mesh at each place. What is placed at no number
   * counts for nothing.
   *
   * @param mesh what is repeated
   * @param placings where
   * @param rgba a colour each, or empty
   * @return the shape
   */
  public static Instances of(TriangleMesh mesh, FloatBuffer placings, Optional<ByteBuffer> rgba) {
    return new Instances(mesh, placings, rgba, mesh.bounds().flatMap(box -> around(box, placings)));
  }

  private static Optional<Box3> around(Box3 mesh, FloatBuffer placings) {
    Optional<Box3> all = Optional.empty();
    for (int from = placings.position(); from < placings.limit(); from += PLACING) {
      Vector3 scale = vector(placings, from + 7);
      Quaternion turn = new Quaternion(placings.get(from + 3), placings.get(from + 4), placings.get(from + 5),
          placings.get(from + 6));
      RigidTransform at = new RigidTransform(vector(placings, from), turn);
      Box3 box = new Box3(scaled(mesh.low(), scale), scaled(mesh.high(), scale)).in(at);
      if (box.low().isFinite() && box.high().isFinite()) {
        all = Optional.of(all.map(box::union).orElse(box));
      }
    }
    return all;
  }

  private static Vector3 vector(FloatBuffer numbers, int from) {
    return new Vector3(numbers.get(from), numbers.get(from + 1), numbers.get(from + 2));
  }

  private static Vector3 scaled(Vector3 place, Vector3 scale) {
    return new Vector3(place.x() * scale.x(), place.y() * scale.y(), place.z() * scale.z());
  }

  @Override
  public int elements() {
    return placings.remaining() / PLACING;
  }

  @Override
  public long bytes() {
    return mesh.bytes() + elements() * (rgba.isPresent() ? 44L : 40L);
  }
}
