package org.robotui.gl.shape;

import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.util.Optional;

/**
 * One mesh many times: arrows of poses, cubes and spheres of marker lists.
 *
 * @param mesh what is repeated
 * @param placings ten numbers each: x, y, z; the unit quaternion x, y, z, w; the scale along the mesh's x, y, z
 * @param rgba four bytes red, green, blue, alpha each; empty where the material colours all
 * @param bounds where they lie
 */
public record Instances(TriangleMesh mesh, FloatBuffer placings, Optional<ByteBuffer> rgba, Optional<Box3> bounds) implements Shape {
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
   * A mesh many times, with its bounds computed: a ball around the mesh at each place, scaled by the greatest scale.
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
    float[] centers = new float[placings.remaining() / PLACING * 3];
    double greatest = 0;
    for (int i = 0; i < centers.length / 3; i++) {
      int from = placings.position() + i * PLACING;
      for (int axis = 0; axis < 3; axis++) {
        centers[3 * i + axis] = placings.get(from + axis);
        double scale = Math.abs(placings.get(from + 7 + axis));
        greatest = Double.isFinite(scale) ? Math.max(greatest, scale) : greatest;
      }
    }
    double reach = (mesh.center().norm() + mesh.radius()) * greatest;
    return Box3.around(FloatBuffer.wrap(centers)).map(box -> box.grown(reach));
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
