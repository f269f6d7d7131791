package org.robotui.core.internal.config;

import java.util.List;
import java.util.Optional;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.ValueType;
import org.robotui.api.host.Problem;
import org.robotui.data.ClockKind;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.data.geometry.FrameTransform;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;

/** Reads how the robots of a RUIC stand to one another: {@code frames: [{parent: r1/map, child: r2/map, x: 2}]}. */
final class FramesReader {
  private static final ValueType METRES = new ValueType.Num(-1e7, 1e7, "m");
  private static final ValueType RADIANS = new ValueType.Num(-10, 10, "rad");
  private static final Schema EDGE = Schema.of(
      Setting.required("parent", new ValueType.Text(), "a frame of one robot, as robot/frame"),
      Setting.required("child", new ValueType.Text(), "a frame of another one"),
      Setting.of("x", METRES, 0.0, "where the child is in the parent"),
      Setting.of("y", METRES, 0.0, "where the child is in the parent"),
      Setting.of("z", METRES, 0.0, "where the child is in the parent"),
      Setting.of("roll", RADIANS, 0.0, "how it is turned"),
      Setting.of("pitch", RADIANS, 0.0, "how it is turned"),
      Setting.of("yaw", RADIANS, 0.0, "how it is turned"));

  private final List<Problem> problems;

  FramesReader(List<Problem> problems) {
    this.problems = problems;
  }

  List<FrameTransform> read(YamlValue value) {
    return Shape.items(value).stream()
        .flatMap(item -> Shape.section(item, "the transform between two frames", problems).stream())
        .flatMap(section -> edge(section).stream()).toList();
  }

  private Optional<FrameTransform> edge(YamlValue.Section section) {
    Settings s = new ValueReader(problems).settings(section, EDGE);
    Optional<FrameId> child = frame(s, "child", section);
    return frame(s, "parent", section).flatMap(parent -> child.map(c -> edge(parent, c, s)));
  }

  private static FrameTransform edge(FrameId parent, FrameId child, Settings s) {
    RigidTransform place = new RigidTransform(new Vector3(s.number("x"), s.number("y"), s.number("z")),
        Quaternion.fromRollPitchYaw(s.number("roll"), s.number("pitch"), s.number("yaw")));
    return new FrameTransform(parent, child, new Stamp(0, ClockKind.ROBOT), place, true);
  }

  private Optional<FrameId> frame(Settings s, String key, YamlValue.Section section) {
    String written = s.has(key) ? s.text(key) : "";
    int cut = written.indexOf('/');
    if (cut > 0 && cut < written.length() - 1) {
      return Optional.of(new FrameId(written.substring(0, cut), written.substring(cut + 1)));
    }
    section.get(key).ifPresent(v -> problems
        .add(v.place().error("'" + written + "' is no frame; write robot/frame, for example Natalie/map")));
    return Optional.empty();
  }
}
