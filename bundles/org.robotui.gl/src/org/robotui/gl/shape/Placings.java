package org.robotui.gl.shape;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;
import java.util.Optional;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;

/** Collects where the instances of a mesh are. Not safe for several threads; used once. */
public final class Placings {
  private static final int FLOAT = 4;

  private final FloatBuffer placings;
  private final ByteBuffer rgba;
  private boolean colored;

  /**
   * Room for some.
   *
   * @param most how many can be added
   */
  public Placings(int most) {
    placings = ByteBuffer.allocateDirect(Math.multiplyExact(most, Instances.PLACING * FLOAT))
        .order(ByteOrder.nativeOrder()).asFloatBuffer();
    rgba = ByteBuffer.allocateDirect(Math.multiplyExact(most, 4));
  }

  /**
   * Adds one in the colour of the material.
   *
   * @param shapeFromMesh where it is; one that is not finite is left out
   * @param scale along the mesh's x, y, z
   * @return this
   */
  public Placings add(RigidTransform shapeFromMesh, Vector3 scale) {
    return add(shapeFromMesh, scale, Rgba.WHITE, false);
  }

  /**
   * Adds one in a colour of its own. Once one has, all that have none are white.
   *
   * @param shapeFromMesh where it is; one that is not finite is left out
   * @param scale along the mesh's x, y, z
   * @param color multiplied with the material's
   * @return this
   */
  public Placings add(RigidTransform shapeFromMesh, Vector3 scale, Rgba color) {
    return add(shapeFromMesh, scale, color, true);
  }

  /**
   * How many were added.
   *
   * @return those that were finite
   */
  public int count() {
    return placings.position() / Instances.PLACING;
  }

  /**
   * The shape.
   *
   * @param mesh what is repeated
   * @return it at all places added
   */
  public Instances of(TriangleMesh mesh) {
    FloatBuffer all = placings.duplicate().flip();
    return Instances.of(mesh, all, colored ? Optional.of(rgba.duplicate().flip()) : Optional.empty());
  }

  private Placings add(RigidTransform at, Vector3 scale, Rgba color, boolean own) {
    Vector3 place = at.translation();
    Quaternion turn = at.rotation();
    if (place.isFinite() && scale.isFinite() && Double.isFinite(turn.norm())) {
      placings.put((float) place.x()).put((float) place.y()).put((float) place.z());
      placings.put((float) turn.x()).put((float) turn.y()).put((float) turn.z()).put((float) turn.w());
      placings.put((float) scale.x()).put((float) scale.y()).put((float) scale.z());
      rgba.putInt(color.packed());
      colored |= own;
    }
    return this;
  }
}
