package org.robotui.uic.joints.internal;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.eclipse.swt.widgets.Composite;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.ValueType;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.data.joint.JointState;
import org.robotui.data.joint.JointState.Joint;
import org.robotui.testkit.FakeInput;
import org.robotui.testkit.FakeUicContext;
import org.robotui.testkit.GalleryWindow;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.UiContext;

/** Shows the view in all its states side by side, for a person to look at: {@code Gallery dark|light}. */
record Gallery(GalleryWindow window, Theme theme) {
  static final SourceId ARM = new SourceId("base", "/joint_states");
  static final SourceId GRIPPER = new SourceId("base", "/gripper/joint_states");

  private static final long MS = 1_000_000;

  public static void main(String[] arguments) {
    GalleryWindow.show(display -> Themes.of(display, arguments[0]), theme -> theme.color(Role.LINE),
        (window, theme) -> new Gallery(window, theme).fill());
  }

  private void fill() {
    cell(0, 0, 900, 420, c -> arm(c));
    cell(906, 0, 694, 420, c -> {
      configured(c);
      arm(c);
    });
    cell(0, 426, 1100, 290, c -> {
      arm(c);
      gripper(c);
    });
    cell(1106, 426, 494, 290, c -> {
      arm(c);
      c.settings().set(JointsType.DEGREES, true);
    });
    cell(0, 722, 360, 278, c -> arm(c));
    cell(366, 722, 400, 278, c -> {
      arm(c);
      c.input(JointsType.JOINTS).state(new InputState.Stale(4.2, "silent"));
    });
    cell(772, 722, 270, 278, c -> {});
    cell(1048, 722, 270, 278,
        c -> c.input(JointsType.JOINTS).state(new InputState.Waiting("base./joint_states: nothing came yet")));
    cell(1324, 722, 276, 278, c -> c.input(JointsType.JOINTS).put(ARM, new JointState(List.of()), 0, Optional.empty()));
  }

  static void configured(FakeUicContext context) {
    context.settings().set(JointsType.UNITS,
        Map.of("shoulder_pan_joint", "rad", "shoulder_lift_joint", "rad", "elbow_joint", "rad",
            "wrist_1_joint", "rad", "wrist_2_joint", "rad", "wrist_3_joint", "rad", "lift_joint", "m"));
    context.settings().set(JointsType.LIMITS,
        Map.of("shoulder_pan_joint", limits(-3.14, 3.14), "elbow_joint", limits(-1, 1),
            "lift_joint", limits(0, 0.4)));
  }

  private static Settings limits(double min, double max) {
    ValueType any = new ValueType.Num(-10, 10, "");
    return new Settings(Schema.of(Setting.required(JointsType.MIN, any, ""), Setting.required(JointsType.MAX, any, "")),
        Map.of(JointsType.MIN, min, JointsType.MAX, max));
  }

  static void arm(FakeUicContext context) {
    FakeInput<JointState> input = context.input(JointsType.JOINTS);
    for (int i = 0; i < 60; i++) {
      double phase = i * 0.1;
      List<Joint> joints = new ArrayList<>(List.of(
          new Joint("shoulder_pan_joint", Math.sin(phase), Math.cos(phase), 12.4),
          new Joint("shoulder_lift_joint", -1.2 + 0.2 * Math.cos(phase), 0, -31.25),
          new Joint("elbow_joint", 0.6 * phase - 1.9, 0.6, 7.5),
          new Joint("wrist_1_joint", -0.5, Double.NaN, Double.NaN),
          new Joint("wrist_2_joint", Double.NaN, Double.NaN, Double.NaN),
          new Joint("lift_joint", 0.3125, 0, 143)));
      if (i < 30) {
        joints.add(new Joint("wrist_3_joint", 0.1 * phase, 0, 0.2));
      }
      input.put(ARM, new JointState(joints), i * 100 * MS, Optional.empty());
    }
  }

  private static void gripper(FakeUicContext context) {
    for (int i = 0; i < 60; i++) {
      context.input(JointsType.JOINTS).put(GRIPPER,
          new JointState(List.of(new Joint("finger_left", 0.01 + i * 1e-4, 0.002, 1.1),
              new Joint("finger_right", 0.01 + i * 1e-4, 0.002, 1.1))),
          i * 100 * MS, Optional.empty());
    }
    context.input(JointsType.JOINTS).state(GRIPPER, new InputState.Stale(3.1, "silent"));
  }

  private void cell(int x, int y, int width, int height, Consumer<FakeUicContext> prepare) {
    FakeUicContext context = new FakeUicContext("joints", new JointsType().schema());
    prepare.accept(context);
    Composite part = window.cell(x, y, width, height);
    JointsUic uic = new JointsUic(context.input(JointsType.JOINTS), context.input(JointsType.MESSAGES), context);
    uic.tick(59 * 100 * MS + 12 * MS);
    uic.createControl(part, UiContext.of(theme, part::setData));
    part.layout(true, true);
  }
}
