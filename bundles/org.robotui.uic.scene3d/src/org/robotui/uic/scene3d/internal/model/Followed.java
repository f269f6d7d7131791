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
  private boolean away;
  private String last = "";

  /**
   * Follows nothing.
   *
   * @param away whether the camera is where it was left at an earlier run, from where what is followed may have moved
   */
  public Followed(Frames frames, CameraMotion rig, boolean away) {
    this.frames = frames;
    this.rig = rig;
    this.away = away;
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
      Optional<RigidTransform> place = place(wanted, settings, fixed);
      place.filter(p -> away).ifPresent(p -> rig.move(pose -> pose.at(p.translation())));
      away &= place.isEmpty();
      rig.follow(place, settings.flag(SceneOptions.FOLLOW_YAW));
    } else {
      away = false;
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
