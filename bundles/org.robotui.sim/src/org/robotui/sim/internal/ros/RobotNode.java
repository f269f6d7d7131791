package org.robotui.sim.internal.ros;

import org.robotui.ros.RosNode;
import org.robotui.ros.XmlRpcValue;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.SimulatedRobot;
import org.robotui.sim.internal.Simulation;
import org.robotui.sim.internal.message.Frames;
import org.robotui.sim.internal.message.Places;
import org.robotui.sim.internal.message.RobotClock;
import org.robotui.sim.internal.message.RobotOffer;

/** The simulated robot on a node of ROS 1. {@link #publish} is for one thread; close it when that thread has ended. */
final class RobotNode implements AutoCloseable {
  private final Simulation simulation;
  private final RobotOffer offer;
  private final MoveBase moveBase;

  /**
   * @param simTime whether the robot is the source of time for all nodes
   * @param stamp the time now, nanoseconds
   */
  RobotNode(RosNode node, SimulatedRobot robot, boolean simTime, long stamp) {
    simulation = robot.simulation();
    RobotClock clock = new RobotClock(stamp);
    robot.events().listen(new EventLog(node, clock::nanos));
    Places places = new Places(new Frames(node.name().namespace().text().substring(1)), simulation::state);
    RosMessageNode messages = new RosMessageNode(node);
    moveBase = new MoveBase(messages, simulation, places, clock, robot.events());
    offer = new RobotOffer(messages, robot, places, clock, simTime, moveBase::drive);
    node.parameters().set("robot_description", XmlRpcValue.of(offer.description()));
    new Tuner(node, simulation);
  }

  /**
   * Publishes what is due with a step.
   *
   * @param stamp the time now, nanoseconds
   */
  void publish(long step, long stamp) {
    RobotState state = simulation.state();
    offer.publish(step, state, stamp);
    moveBase.publish(step, state, stamp);
  }

  @Override
  public void close() {
    offer.close();
  }
}
