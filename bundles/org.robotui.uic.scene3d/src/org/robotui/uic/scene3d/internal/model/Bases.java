package org.robotui.uic.scene3d.internal.model;

import java.util.Optional;
import org.robotui.api.config.Settings;
import org.robotui.api.frame.Frames;
import org.robotui.data.FrameId;
import org.robotui.geometry.RigidTransform;

/** Where robots are, also while nobody sees the scene. */
public final class Bases {
  private Bases() {}

  /** Frame from the base of a robot; none where that is not known. */
  public static Optional<RigidTransform> in(FrameId frame, String robot, Frames known, Settings settings) {
    Frames frames = new JoinedFrames(known, Joint.read(settings));
    return Robots.base(robot, frames.all()).flatMap(base -> frames.lookup(frame, base, Optional.empty()).transform());
  }
}
