package org.robotui.entity.path.internal.display;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.robotui.data.FrameId;
import org.robotui.geometry.RigidTransform;
import org.robotui.gl.shape.Properties;

/** What a selected pose says. */
final class PoseText {
  private PoseText() {}

  static Properties of(String title, FrameId frame, RigidTransform pose) {
    List<Properties.Entry> entries = new ArrayList<>();
    entries.add(new Properties.Entry("frame", frame.name()));
    entries.add(metres("x", pose.translation().x()));
    entries.add(metres("y", pose.translation().y()));
    entries.add(metres("z", pose.translation().z()));
    entries.add(degrees("roll", pose.rotation().roll()));
    entries.add(degrees("pitch", pose.rotation().pitch()));
    entries.add(degrees("yaw", pose.rotation().yaw()));
    return new Properties(title, entries);
  }

  static Properties.Entry metres(String name, double value) {
    return new Properties.Entry(name, String.format(Locale.ROOT, "%.3f m", value));
  }

  static Properties.Entry degrees(String name, double value) {
    return new Properties.Entry(name, String.format(Locale.ROOT, "%.1f\u00b0", Math.toDegrees(value)));
  }
}
