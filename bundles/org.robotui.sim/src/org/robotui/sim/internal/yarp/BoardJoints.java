package org.robotui.sim.internal.yarp;

import java.util.List;

/** The joints of a control board. Those that turn are told in degrees, those that slide in metres. */
interface BoardJoints {
  /** One joint; it moves from lower to upper, at most so fast. */
  record BoardJoint(String name, boolean slides, double lower, double upper, double fastest) {}

  /** Where a joint is, and how fast it moves. */
  record JointMotion(double position, double speed) {}

  List<BoardJoint> joints();

  /** Of all joints, now. */
  List<JointMotion> motions();

  /** Goes there and stays; joints move by themselves until one is told something. */
  void move(int joint, double position, double speed);

  /** Stays where it is. */
  void stay(int joint);
}
