package org.robotui.data.geometry;

import org.robotui.data.Data;
import org.robotui.data.InFrame;
import org.robotui.geometry.RigidTransform;

/** Where something is and how it is turned, in a named frame. */
public interface Pose extends Data, InFrame {
  /**
   * Position in metres and orientation.
   *
   * @return the transform frame from body
   */
  RigidTransform pose();
}
