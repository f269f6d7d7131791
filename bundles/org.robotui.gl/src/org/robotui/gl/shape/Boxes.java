package org.robotui.gl.shape;

/** Bodies with flat sides and sharp edges. */
final class Boxes {
  private Boxes() {}

  /** A cube around the origin. */
  static TriangleMesh box(double half) {
    MeshBuilder mesh = new MeshBuilder();
    for (int axis = 0; axis < 3; axis++) {
      side(mesh, half, axis, 1);
      side(mesh, half, axis, -1);
    }
    return mesh.build();
  }

  private static void side(MeshBuilder mesh, double half, int axis, int sign) {
    int[] corners = new int[4];
    for (int i = 0; i < 4; i++) {
      double[] at = new double[3];
      double[] normal = new double[3];
      normal[axis] = sign;
      at[axis] = sign * half;
      at[(axis + 1) % 3] = (i == 1 || i == 2) ? half : -half;
      at[(axis + 2) % 3] = (i < 2 ? -half : half) * sign;
      corners[i] = mesh.corner(at[0], at[1], at[2], normal[0], normal[1], normal[2]);
    }
    mesh.quad(corners[0], corners[1], corners[2], corners[3]);
  }
}
