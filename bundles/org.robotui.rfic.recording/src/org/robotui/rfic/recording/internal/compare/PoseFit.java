package org.robotui.rfic.recording.internal.compare;

import java.util.List;
import java.util.Locale;
import org.robotui.geometry.RigidTransform;

/** How the way of the second recording is moved onto that of the first before it is compared with it. */
public enum PoseFit {
  /** It stays where it is. */
  NONE,
  /** Its first pose becomes the first pose of the other. */
  ORIGIN,
  /** Moved and turned around the vertical axis, so that the squares of distances are least. */
  YAW,
  /** Moved and turned in any way, so that the squares of distances are least. */
  SE3;

  private static final int FEWEST = 3;

  /**
   * As it is written.
   *
   * @return a word
   */
  public String word() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** What is to be applied to the poses that are moved. */
  RigidTransform of(List<RigidTransform> moved, List<RigidTransform> fixed) throws CompareException {
    if (this == SE3 && moved.size() < FEWEST) {
      throw new CompareException("a free alignment needs three poses and more: align by yaw, origin or none");
    }
    return switch (this) {
      case NONE -> RigidTransform.IDENTITY;
      case ORIGIN -> fixed.getFirst().times(moved.getFirst().inverse());
      case YAW -> new PointFit(moved, fixed).level();
      case SE3 -> new PointFit(moved, fixed).free().orElseThrow(() -> new CompareException(
          "both ways lie on a line or at one place, so that no turn fits best: align by yaw, origin or none"));
    };
  }
}
