package org.robotui.rfic.xbot.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.robotui.data.ClockKind;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.data.geometry.FrameTransform;
import org.robotui.data.geometry.TransformSet;
import org.robotui.data.joint.JointState;
import org.robotui.geometry.Vector3;

class ModelFramesTest {
  private static final String URDF = """
      <robot name="arm">
        <link name="base"/><link name="upper"/><link name="tool"/>
        <joint name="lift" type="prismatic"><origin xyz="0 0 1"/><axis xyz="0 0 1"/><limit lower="0" upper="1" effort="1" velocity="1"/>
          <parent link="base"/><child link="upper"/></joint>
        <joint name="wrist_ft" type="fixed"><origin xyz="0 0.2 0"/><parent link="upper"/><child link="tool"/></joint>
      </robot>""";
  private static final Stamp NOW = new Stamp(5, ClockKind.WALL);

  private final ModelFrames frames = new ModelFrames("Marvin", URDF);

  @Test
  void whatMovesFollowsItsJointAndWhatIsFixedIsToldAsSuch() {
    FrameTransform moving = only(frames.moving(new JointState(List.of(new JointState.Joint("lift", 0.25, 0, 0))), NOW));
    FrameTransform fixed = only(frames.fixed(NOW));

    assertEquals(new FrameId("Marvin", "base"), moving.parent());
    assertEquals(new FrameId("Marvin", "upper"), moving.child());
    assertEquals(new Vector3(0, 0, 1.25), moving.parentFromChild().translation());
    assertEquals(NOW, moving.stamp());
    assertTrue(fixed.fixed() && !moving.fixed());
    assertEquals(new FrameId("Marvin", "tool"), fixed.child());
    assertEquals(new Vector3(0, 0.2, 0), fixed.parentFromChild().translation());
  }

  @Test
  void aSensorThatIsNamedByItsJointMeasuresInTheLinkBehindIt() {
    assertEquals(new FrameId("Marvin", "tool"), frames.sensor("wrist_ft"));
    assertEquals(new FrameId("Marvin", "imu_link"), frames.sensor("imu_link"));
  }

  @Test
  void aModelThatCannotBeReadHasNoFrames() {
    ModelFrames none = new ModelFrames("Marvin", "<robot");

    assertEquals(List.of(), none.fixed(NOW).transforms());
    assertEquals(new FrameId("Marvin", "wrist_ft"), none.sensor("wrist_ft"));
  }

  private static FrameTransform only(TransformSet set) {
    assertEquals(1, set.transforms().size());
    return set.transforms().getFirst();
  }
}
