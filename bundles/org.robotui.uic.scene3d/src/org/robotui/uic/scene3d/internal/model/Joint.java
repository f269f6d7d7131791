package org.robotui.uic.scene3d.internal.model;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.config.Settings;
import org.robotui.data.FrameId;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.ui.display.Written;
import org.robotui.uic.scene3d.internal.SceneOptions;

/**
 * How two robots stand to one another, by configuration.
 *
 * @param parent a frame of one
 * @param child a frame of the other
 * @param parentFromChild where it is
 */
public record Joint(FrameId parent, FrameId child, RigidTransform parentFromChild) {
  /** Reads those of the settings; one that names no robot is left out. */
  public static List<Joint> read(Settings settings) {
    return settings.list(SceneOptions.FRAMES).stream().map(Written::fields).flatMap(f -> joint(f).stream()).toList();
  }

  private static Optional<Joint> joint(Map<String, Object> fields) {
    Quaternion turned = Quaternion.fromRollPitchYaw(
        Written.number(fields, "roll", 0), Written.number(fields, "pitch", 0), Written.number(fields, "yaw", 0));
    Vector3 place =
        new Vector3(Written.number(fields, "x", 0), Written.number(fields, "y", 0), Written.number(fields, "z", 0));
    Optional<FrameId> child = frame(Written.text(fields, SceneOptions.CHILD));
    return frame(Written.text(fields, SceneOptions.PARENT))
        .flatMap(parent -> child.map(c -> new Joint(parent, c, new RigidTransform(place, turned))));
  }

  /** A frame written as robot/frame or robot:frame. */
  static Optional<FrameId> frame(String written) {
    int cut = written.indexOf(written.indexOf(':') > 0 ? ':' : '/');
    return cut > 0 ? Optional.of(new FrameId(written.substring(0, cut).strip(), written.substring(cut + 1).strip()))
        : Optional.empty();
  }
}
