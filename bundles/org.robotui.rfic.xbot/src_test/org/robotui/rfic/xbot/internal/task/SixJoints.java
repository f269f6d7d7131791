package org.robotui.rfic.xbot.internal.task;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.robotui.urdf.RobotModel;
import org.robotui.urdf.Urdf;

/** An arm with six joints, bent. */
final class SixJoints {
  static final List<String> NAMES = List.of("yaw", "shoulder", "elbow", "roll", "pitch", "turn");
  static final RobotModel MODEL = Urdf.parse(text()).found().orElseThrow();
  static final FrameTask HAND =
      new FrameTask("Arm", "hand", "hand", "base", 1, FrameTask.Phase.THERE, "111111", 0.1, 0.5);

  private SixJoints() {}

  private static String text() {
    return "<robot name=\"six\"><link name=\"base\"/>" + joint("yaw", "base", "l1", "0 0 0", "0 0 1")
        + joint("shoulder", "l1", "l2", "0 0 0.3", "0 1 0") + joint("elbow", "l2", "l3", "0 0 0.4", "0 1 0")
        + joint("roll", "l3", "l4", "0 0 0.3", "0 0 1") + joint("pitch", "l4", "l5", "0 0 0.1", "0 1 0")
        + joint("turn", "l5", "l6", "0 0 0.1", "0 0 1")
        + "<link name=\"hand\"/><joint name=\"mount\" type=\"fixed\"><origin xyz=\"0 0 0.1\"/><parent link=\"l6\"/>"
        + "<child link=\"hand\"/></joint></robot>";
  }

  private static String joint(String name, String parent, String child, String origin, String axis) {
    return "<link name=\"" + child + "\"/><joint name=\"" + name + "\" type=\"revolute\"><origin xyz=\"" + origin
        + "\"/><axis xyz=\"" + axis + "\"/><parent link=\"" + parent + "\"/><child link=\"" + child
        + "\"/><limit lower=\"-2.2\" upper=\"2.2\" velocity=\"2\" effort=\"1\"/></joint>";
  }

  static Map<String, Double> bent() {
    return new HashMap<>(Map.of("yaw", 0.0, "shoulder", 0.4, "elbow", 1.2, "roll", 0.0, "pitch", 0.9, "turn", 0.0));
  }

  static TaskArm arm() {
    return new TaskArm(MODEL, NAMES, bent());
  }
}
