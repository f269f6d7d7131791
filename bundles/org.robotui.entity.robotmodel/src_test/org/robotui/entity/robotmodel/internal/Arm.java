package org.robotui.entity.robotmodel.internal;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.robotui.data.array.Doubles;
import org.robotui.data.joint.JointState;
import org.robotui.data.joint.JointTrajectory;
import org.robotui.data.joint.RobotDescription;
import org.robotui.testkit.display.FakePlaces;

/** A small arm: it turns on its base, slides up a mast, and has a hand that goes on to a tool. */
final class Arm {
  static final String URDF = """
      <robot name="arm">
        <link name="base"><visual><origin xyz="0 0 0.1"/><geometry><cylinder radius="0.3" length="0.2"/></geometry></visual></link>
        <link name="mast"><visual><origin xyz="0 0 0.5"/><geometry><box size="0.12 0.12 1"/></geometry></visual></link>
        <link name="beam"><visual><origin xyz="0.35 0 0"/><geometry><box size="0.8 0.1 0.1"/></geometry></visual></link>
        <link name="tool"><visual><geometry><sphere radius="0.09"/></geometry></visual></link>
        <joint name="turn" type="continuous"><parent link="base"/><child link="mast"/><origin xyz="0 0 0.2"/><axis xyz="0 0 1"/></joint>
        <joint name="lift" type="prismatic"><parent link="mast"/><child link="beam"/><origin xyz="0 0 0.3"/><axis xyz="0 0 1"/>
          <limit lower="0" upper="0.7"/></joint>
        <joint name="mount" type="fixed"><parent link="beam"/><child link="tool"/><origin xyz="0.75 0 0"/></joint>
      </robot>
      """;

  private Arm() {}

  static RobotDescription description() {
    return new RobotDescription(FakePlaces.ROBOT, "robot_description", URDF, "", List.of());
  }

  static JointState at(double turn, double lift) {
    return new JointState(List.of(joint("turn", turn), joint("lift", lift)));
  }

  static JointState.Joint joint(String name, double position) {
    return new JointState.Joint(name, position, Double.NaN, Double.NaN);
  }

  static JointTrajectory.Point point(double seconds, double... positions) {
    return new JointTrajectory.Point(seconds, Doubles.of(positions), Doubles.EMPTY, Doubles.EMPTY, Doubles.EMPTY);
  }

  static JointTrajectory way(JointTrajectory.Point... points) {
    return new JointTrajectory(List.of("turn", "lift"), Arrays.asList(points));
  }

  /** A quarter of a turn while it rises by half a metre, in some points during two seconds. */
  static JointTrajectory sweep(int points) {
    return way(IntStream.range(0, points)
        .mapToObj(i -> point(2.0 * i / (points - 1), Math.PI / 2 * i / (points - 1), 0.5 * i / (points - 1)))
        .toArray(JointTrajectory.Point[]::new));
  }
}
