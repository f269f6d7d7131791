package org.robotui.gl.shape;

import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.Optional;

/**
 * Bodies of unit size with normals, of few triangles, to be scaled and placed by {@link Instances}. Those without
 * parameters answer the same object each time, so that it is sent to the graphics card once.
 */
public final class Meshes {
  /** Corners around what is round. */
  private static final int AROUND = 16;

  private static final double HEAD = 0.23;
  private static final double AXIS = 0.05;
  private static final Rgba X = Rgba.of(0xe5484d);
  private static final Rgba Y = Rgba.of(0x46a758);
  private static final Rgba Z = Rgba.of(0x3e7bfa);

  private static final TriangleMesh CUBE = Boxes.box(0.5);
  private static final TriangleMesh SPHERE = Spheres.sphere(2);
  private static final TriangleMesh COARSE_SPHERE = Spheres.sphere(1);
  private static final TriangleMesh CYLINDER =
      new Lathe(AROUND).disc(Lathe.Along.Z, -0.5, 0.5, -1).tube(Lathe.Along.Z, -0.5, 0.5, 0.5, 0.5)
          .disc(Lathe.Along.Z, 0.5, 0.5, 1).build();
  private static final TriangleMesh CONE =
      new Lathe(AROUND).tube(Lathe.Along.X, 0, 0, 1, 0.5).disc(Lathe.Along.X, 1, 0.5, 1).build();
  private static final TriangleMesh DISC = new Lathe(2 * AROUND).disc(Lathe.Along.Z, 0, 0.5, 1).build();
  private static final TriangleMesh ARROW = arrow(1 - HEAD, 1, HEAD, 2);
  private static final TriangleMesh AXES = new Lathe(AROUND / 2)
      .color(X).tube(Lathe.Along.X, 0, AXIS, 1, AXIS).disc(Lathe.Along.X, 1, AXIS, 1)
      .color(Y).tube(Lathe.Along.Y, 0, AXIS, 1, AXIS).disc(Lathe.Along.Y, 1, AXIS, 1)
      .color(Z).tube(Lathe.Along.Z, 0, AXIS, 1, AXIS).disc(Lathe.Along.Z, 1, AXIS, 1)
      .build();
  private static final TriangleMesh QUAD = flat();

  private Meshes() {}

  /**
   * A cube around the origin.
   *
   * @return edges of 1 metre; 12 triangles
   */
  public static TriangleMesh cube() {
    return CUBE;
  }

  /**
   * A sphere around the origin; scaled unequally, an ellipsoid.
   *
   * @return diameter of 1 metre; 320 triangles
   */
  public static TriangleMesh sphere() {
    return SPHERE;
  }

  /**
   * A sphere that is seen small or thousands of times.
   *
   * @return diameter of 1 metre; 80 triangles
   */
  public static TriangleMesh coarseSphere() {
    return COARSE_SPHERE;
  }

  /**
   * A cylinder around the origin, along z, with lids.
   *
   * @return diameter and height of 1 metre; 64 triangles
   */
  public static TriangleMesh cylinder() {
    return CYLINDER;
  }

  /**
   * A cone from its tip in the origin along x, with a lid.
   *
   * @return 1 metre long, the lid's diameter 1 metre; 32 triangles
   */
  public static TriangleMesh cone() {
    return CONE;
  }

  /**
   * A disc around the origin in the x-y plane.
   *
   * @return diameter of 1 metre; 32 triangles
   */
  public static TriangleMesh disc() {
    return DISC;
  }

  /**
   * An arrow from the origin along x, in the proportions that rviz draws: y and z scale the diameter of its shaft, the
   * head is twice as wide.
   *
   * @return 1 metre long, its shaft 1 metre wide
   */
  public static TriangleMesh arrow() {
    return ARROW;
  }

  /**
   * An arrow from the origin along x. Not kept: keep it yourself.
   *
   * @param shaft length of the shaft, metres
   * @param width diameter of the shaft, metres
   * @param head length of the head, metres
   * @param headWidth diameter of the head, metres
   * @return the arrow
   */
  public static TriangleMesh arrow(double shaft, double width, double head, double headWidth) {
    return new Lathe(AROUND)
        .disc(Lathe.Along.X, 0, width / 2, -1)
        .tube(Lathe.Along.X, 0, width / 2, shaft, width / 2)
        .disc(Lathe.Along.X, shaft, headWidth / 2, -1)
        .tube(Lathe.Along.X, shaft, headWidth / 2, shaft + head, 0)
        .build();
  }

  /**
   * A coordinate system: x red, y green, z blue. Its material should be white.
   *
   * @return rods of 1 metre, a tenth as wide
   */
  public static TriangleMesh axes() {
    return AXES;
  }

  /**
   * A square in the x-y plane from the origin to (1, 1), for pictures: the first row of the texture's pixels lies at y
   * 0.
   *
   * @return edges of 1 metre; 2 triangles
   */
  public static TriangleMesh quad() {
    return QUAD;
  }

  private static TriangleMesh flat() {
    FloatBuffer xyz = FloatBuffer.wrap(new float[]{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
    FloatBuffer normals = FloatBuffer.wrap(new float[]{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
    FloatBuffer uv = FloatBuffer.wrap(new float[]{0, 0, 1, 0, 1, 1, 0, 1});
    return new TriangleMesh(xyz, Optional.of(normals), Optional.of(uv), Optional.empty(),
        IntBuffer.wrap(new int[]{0, 1, 2, 0, 2, 3}),
        Box3.around(xyz));
  }
}
