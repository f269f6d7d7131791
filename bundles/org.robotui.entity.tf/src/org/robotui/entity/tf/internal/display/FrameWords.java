package org.robotui.entity.tf.internal.display;

import java.util.Locale;
import org.robotui.data.FrameId;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.shape.Properties;
import org.robotui.gl.shape.Properties.Entry;

/** What a selected frame says. */
final class FrameWords {
  private FrameWords() {}

  static Properties of(FrameId frame, FrameId parent, RigidTransform place) {
    Vector3 at = place.translation();
    Quaternion q = place.rotation();
    return Properties.of(frame.name(),
        new Entry("robot", frame.robot()),
        new Entry("parent", parent.equals(frame) ? "none that is shown" : parent.name()),
        new Entry("position", String.format(Locale.ROOT, "%.3f, %.3f, %.3f m", at.x(), at.y(), at.z())),
        new Entry("roll, pitch, yaw", String.format(Locale.ROOT, "%.1f, %.1f, %.1f\u00b0",
            Math.toDegrees(q.roll()), Math.toDegrees(q.pitch()), Math.toDegrees(q.yaw()))),
        new Entry("quaternion", String.format(Locale.ROOT, "%.4f, %.4f, %.4f, %.4f", q.x(), q.y(), q.z(), q.w())));
  }
}
