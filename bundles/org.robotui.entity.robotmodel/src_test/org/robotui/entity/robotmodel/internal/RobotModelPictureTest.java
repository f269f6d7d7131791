package org.robotui.entity.robotmodel.internal;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.data.joint.JointState;
import org.robotui.data.joint.RobotDescription;
import org.robotui.geometry.Vector3;
import org.robotui.testkit.Displays;
import org.robotui.testkit.ScenePictures;

/** How models look. */
@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class RobotModelPictureTest {
  private static final String CRANE = """
      <robot name="crane">
        <material name="orange"><color rgba="0.95 0.55 0.15 1"/></material>
        <link name="base"><visual><origin xyz="0 0 0.1"/><geometry><cylinder radius="0.4" length="0.2"/></geometry></visual></link>
        <link name="mast"><visual><origin xyz="0 0 0.6"/><geometry><box size="0.15 0.15 1.2"/></geometry><material name="orange"/></visual></link>
        <link name="boom"><visual><origin xyz="0.4 0 0"/><geometry><box size="0.9 0.1 0.1"/></geometry><material name="orange"/></visual></link>
        <link name="load"><visual><geometry><sphere radius="0.15"/></geometry><material name="b"><color rgba="0.2 0.5 0.9 0.6"/></material></visual></link>
        <joint name="stand" type="fixed"><parent link="base"/><child link="mast"/><origin xyz="0 0 0.2"/></joint>
        <joint name="swing" type="continuous"><parent link="mast"/><child link="boom"/><origin xyz="0 0 1.2"/><axis xyz="0 0 1"/></joint>
        <joint name="rope" type="prismatic"><parent link="boom"/><child link="load"/><origin xyz="0.8 0 -0.2"/><axis xyz="0 0 -1"/><limit lower="0" upper="1"/></joint>
      </robot>
      """;

  @Test
  void aCraneWithAxes() {
    Bench bench = new Bench();
    bench.settings.set(RobotModelType.AXES, true);
    JointState joints =
        new JointState(List.of(new JointState.Joint("swing", 0.6, 0, 0), new JointState.Joint("rope", 0.3, 0, 0)));
    try (ScenePictures pictures = new ScenePictures()) {
      pictures.assertLike(RobotModelPictureTest.class, "crane", ScenePictures.request(
          bench.give(new RobotDescription(Bench.ROBOT, "crane", CRANE, "", List.of())).give(joints).settled().parts(),
          ScenePictures.eye(new Vector3(2, -1.5, 1.5), new Vector3(0.2, 0.2, 0.7))));
    }
  }
}
