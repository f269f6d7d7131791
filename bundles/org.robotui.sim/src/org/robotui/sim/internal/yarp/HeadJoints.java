package org.robotui.sim.internal.yarp;

import java.util.List;
import org.robotui.sim.internal.Command;
import org.robotui.sim.internal.SimulatedRobot;
import org.robotui.sim.internal.robot.Head;
import org.robotui.sim.internal.robot.Neck;

/** The head with two joints that turn: it looks around by itself until a joint is driven. */
final class HeadJoints implements BoardJoints {
  private static final double FASTEST = Math.toDegrees(Neck.FASTEST);
  private static final List<BoardJoint> JOINTS =
      List.of(joint("neck_pan", Neck.MOST_PAN), joint("neck_tilt", Neck.MOST_TILT));

  private final SimulatedRobot robot;
  private final double[] wishes = new double[JOINTS.size()]; // guarded by this, as the following
  private final double[] speeds = {FASTEST, FASTEST};
  private boolean driven;

  HeadJoints(SimulatedRobot robot) {
    this.robot = robot;
  }

  private static BoardJoint joint(String name, double most) {
    return new BoardJoint(name, false, -Math.toDegrees(most), Math.toDegrees(most), FASTEST);
  }

  @Override
  public List<BoardJoint> joints() {
    return JOINTS;
  }

  @Override
  public List<JointMotion> motions() {
    Head head = robot.state().head().orElseThrow();
    return List.of(new JointMotion(Math.toDegrees(head.pan()), Math.toDegrees(head.panSpeed())),
        new JointMotion(Math.toDegrees(head.tilt()), Math.toDegrees(head.tiltSpeed())));
  }

  /** The other joint stays where it is. */
  @Override
  public synchronized void move(int joint, double position, double speed) {
    if (!driven) {
      driven = true;
      for (int i = 0; i < wishes.length; i++) {
        wishes[i] = motions().get(i).position();
      }
    }
    wishes[joint] = position;
    speeds[joint] = speed;
    robot.simulation().submit(new Command.Turn(new Neck.Look(Math.toRadians(wishes[0]), Math.toRadians(wishes[1]),
        Math.toRadians(speeds[0]), Math.toRadians(speeds[1]))));
  }

  @Override
  public synchronized void stay(int joint) {
    move(joint, motions().get(joint).position(), FASTEST);
  }
}
