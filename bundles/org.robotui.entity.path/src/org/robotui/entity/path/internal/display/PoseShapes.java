package org.robotui.entity.path.internal.display;

import java.util.List;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.shape.Instances;
import org.robotui.gl.shape.Material;
import org.robotui.gl.shape.Meshes;
import org.robotui.gl.shape.Placings;
import org.robotui.gl.shape.Rgba;

/** Arrows or axes at poses. */
final class PoseShapes {
  /** Poses of one display at most: 40 bytes each. */
  static final int MOST = 200_000;

  /** Thicker than a lone pose: arrows of many poses are small, and their heads must be seen. */
  private static final double SHAFT = 0.13;

  private PoseShapes() {}

  static Instances of(List<RigidTransform> poses, boolean axes, double length) {
    List<RigidTransform> drawn = poses.stream().filter(PoseShapes::finite).limit(MOST).toList();
    Placings placings = new Placings(drawn.size());
    Vector3 scale = axes ? new Vector3(length, length, length) : new Vector3(length, SHAFT * length, SHAFT * length);
    for (RigidTransform pose : drawn) {
      placings.add(upright(pose), scale);
    }
    return placings.of(axes ? Meshes.axes() : Meshes.arrow());
  }

  /** Whether a pose can be drawn. */
  static boolean finite(RigidTransform pose) {
    return pose.translation().isFinite() && Double.isFinite(pose.rotation().norm());
  }

  /** Axes have colours of their own. */
  static Material material(boolean axes, Rgba color) {
    return Material.lit(axes ? Rgba.WHITE.withAlpha(color.alpha()) : color);
  }

  /** A rotation that was never set (all 0) is none. */
  static RigidTransform upright(RigidTransform pose) {
    double norm = pose.rotation().norm();
    return norm > 1e-9 ? new RigidTransform(pose.translation(), pose.rotation().normalized())
        : new RigidTransform(pose.translation(), Quaternion.IDENTITY);
  }
}
