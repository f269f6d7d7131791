package org.robotui.data;

import org.robotui.geometry.RigidTransform;

/** Where something is and how it is turned, in a named frame. */
public interface Pose extends Data {
  /**
   * The frame in which the pose is given.
   *
   * @return the frame
   */
  FrameId frame();

  /**
   * Position in metres and orientation.
   *
   * @return the transform frame from body
   */
  RigidTransform pose();
}
