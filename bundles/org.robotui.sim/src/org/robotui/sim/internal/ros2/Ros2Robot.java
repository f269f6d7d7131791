package org.robotui.sim.internal.ros2;

import java.util.concurrent.ThreadFactory;
import org.robotui.message.ros.geometry_msgs.PoseStamped;
import org.robotui.message.ros.std_msgs.StdString;
import org.robotui.ros2.Ros2Descriptions;
import org.robotui.ros2.Ros2Log;
import org.robotui.ros2.Ros2LogLevel;
import org.robotui.ros2.Ros2Node;
import org.robotui.sim.internal.Event;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.SimulatedRobot;
import org.robotui.sim.internal.Simulation;
import org.robotui.sim.internal.message.Frames;
import org.robotui.sim.internal.message.Places;
import org.robotui.sim.internal.message.RobotClock;
import org.robotui.sim.internal.message.RobotOffer;
import org.robotui.sim.internal.message.TopicKind;

/** The simulated robot on a node of ROS 2. {@link #publish} is for one thread; close it when that thread has ended. */
final class Ros2Robot implements AutoCloseable {
  private final Simulation simulation;
  private final RobotOffer offer;
  private final NavigateServer navigation;
  private final TuningServer tuning;

  /**
   * @param simTime whether the robot is the source of time for all nodes
   * @param stamp the time now, nanoseconds
   * @param threads makes one for each goal
   */
  Ros2Robot(Ros2Node node, SimulatedRobot robot, boolean simTime, long stamp, ThreadFactory threads) {
    simulation = robot.simulation();
    RobotClock clock = new RobotClock(stamp);
    Ros2Descriptions.offer(node);
    Ros2Log log = Ros2Log.open(node);
    robot.events()
        .listen(event -> log.write(level(event.severity()), event.source(), event.text(), clock.nanos()));
    String namespace = node.name().namespace().text().substring(1);
    Places places = new Places(new Frames(namespace), simulation::state);
    Ros2MessageNode messages = new Ros2MessageNode(node);
    navigation = new NavigateServer(node, simulation, places, clock, robot.events(), threads);
    messages.listen("goal_pose", PoseStamped.class, navigation::drive);
    offer = new RobotOffer(messages, robot, places, clock, simTime, navigation::drive);
    messages.topic("robot_description", StdString.class, TopicKind.LATCHED).send(new StdString(offer.description()));
    tuning = new TuningServer(node, simulation, robot.events());
  }

  private static Ros2LogLevel level(Event.Severity severity) {
    return switch (severity) {
      case INFO -> Ros2LogLevel.INFO;
      case WARN -> Ros2LogLevel.WARN;
      case ERROR -> Ros2LogLevel.ERROR;
    };
  }

  /**
   * Publishes what is due with a step.
   *
   * @param stamp the time now, nanoseconds
   */
  void publish(long step, long stamp) {
    RobotState state = simulation.state();
    offer.publish(step, state, stamp);
    navigation.step(step);
  }

  @Override
  public void close() {
    navigation.close();
    tuning.close();
    offer.close();
  }
}
