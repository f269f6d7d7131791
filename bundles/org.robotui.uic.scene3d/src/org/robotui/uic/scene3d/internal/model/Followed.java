package org.robotui.uic.scene3d.internal.model;

import java.util.Optional;
import org.robotui.api.config.Settings;
import org.robotui.api.frame.Frames;
import org.robotui.data.FrameId;
import org.robotui.geometry.RigidTransform;
import org.robotui.ui.scene.Placer;
import org.robotui.uic.scene3d.internal.SceneOptions;
import org.robotui.uic.scene3d.internal.camera.CameraMotion;

/** Has the camera keep up with a frame. Worker thread. */
public final class Followed {
  private final Frames frames;
  private final CameraMotion rig;
  private String last = "";

  /** Follows nothing. */
  public Followed(Frames frames, CameraMotion rig) {
    this.frames = frames;
    this.rig = rig;
  }

  /** Keeps up; with another frame it begins where the camera is. */
  public void tick(Settings settings, Optional<FrameId> fixed) {
    String wanted = settings.text(SceneOptions.FOLLOW).strip();
    String key = wanted + fixed;
    if (!key.equals(last)) {
      last = key;
      rig.follow(Optional.empty(), false);
    }
    if (!wanted.isEmpty()) {
      rig.follow(place(wanted, settings, fixed), settings.flag(SceneOptions.FOLLOW_YAW));
    }
  }

  /** Where a frame is now. Any thread. */
  public Optional<RigidTransform> where(FrameId frame, Settings settings, Optional<FrameId> fixed) {
    Frames joined = new JoinedFrames(frames, Joint.read(settings));
    return fixed.flatMap(f -> new Placer(joined, f).latest(frame).found());
  }

  private Optional<RigidTransform> place(String wanted, Settings settings, Optional<FrameId> fixed) {
    Frames joined = new JoinedFrames(frames, Joint.read(settings));
    Optional<FrameId> frame = joined.all().stream()
        .filter(
            f -> wanted.equals(f.name()) || wanted.equals(f.toString()) || wanted.equals(f.robot() + '/' + f.name()))
        .findFirst();
    return fixed.flatMap(f -> frame.flatMap(source -> new Placer(joined, f).latest(source).found()));
  }
}
