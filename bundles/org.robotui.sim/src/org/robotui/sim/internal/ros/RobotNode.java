package org.robotui.sim.internal.ros;

import java.util.Optional;
import org.robotui.message.RecordCodec;
import org.robotui.message.ros.rosgraph_msgs.Clock;
import org.robotui.ros.Publisher;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.RosNode;
import org.robotui.ros.XmlRpcValue;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.SimulatedRobot;
import org.robotui.sim.internal.Simulation;
import org.robotui.sim.internal.model.RobotModel;
import org.robotui.sim.internal.sensor.Lidar;

/** The simulated robot on a ROS node. {@link #publish} is for one thread; close it when that thread has ended. */
final class RobotNode implements AutoCloseable {
  private final Simulation simulation;
  private final RobotClock clock;
  private final Publications publications;
  private final CameraPublisher camera;
  private final DepthPublisher depth;
  private final Optional<LidarPublisher> lidar;
  private final MoveBase moveBase;
  private final Waypoint waypoint;
  private final Optional<Publisher<Clock>> simulatedTime;

  /**
   * @param simTime whether the robot is the source of time for all nodes
   * @param stamp the time now, nanoseconds
   */
  RobotNode(RosNode node, SimulatedRobot robot, boolean simTime, long stamp) {
    simulation = robot.simulation();
    clock = new RobotClock(stamp);
    RobotModel model = robot.model();
    Frames frames = new Frames(node.name().namespace().text().substring(1));
    robot.events().listen(new EventLog(node, clock::nanos));
    publications = new Publications(node, robot, frames);
    camera = new CameraPublisher(node, simulation.world(), model.lens(), frames);
    simulatedTime = simTime
        ? Optional.of(node.publisher("/clock", RecordCodec.of(Clock.class), PublisherOptions.standard()))
        : Optional.empty();
    node.parameters().set("robot_description", XmlRpcValue.of(publications.description()));
    publications.publishOnce(robot.map(), stamp);
    depth = new DepthPublisher(node, simulation.world(), model.lens(), frames);
    lidar = model.lidar().map(spec -> new LidarPublisher(node, new Lidar(spec, simulation.random(13)), frames));
    Places places = new Places(frames, simulation::state);
    new Subscriptions(node, simulation, places, robot.events());
    moveBase = new MoveBase(node, simulation, places, clock, robot.events());
    waypoint = new Waypoint(node, simulation.world(), places, moveBase::drive, robot.events());
    new Tuner(node, simulation);
    new Services(node, simulation, new SensorMessages(frames).map(robot.map(), new Stamp(1, stamp)));
  }

  /**
   * Publishes what is due with a step.
   *
   * @param stamp the time now, nanoseconds
   */
  void publish(long step, long stamp) {
    clock.set(stamp);
    RobotState state = simulation.state();
    simulatedTime.ifPresent(publisher -> publisher.publish(new Clock(stamp)));
    publications.publish(step, state, stamp);
    moveBase.publish(step, state, stamp);
    waypoint.publish(step);
    camera.publish(step, state, stamp);
    depth.publish(step, state, stamp);
    lidar.ifPresent(scanner -> scanner.publish(step, simulation.present(), state, stamp));
  }

  @Override
  public void close() {
    camera.close();
    depth.close();
    lidar.ifPresent(LidarPublisher::close);
  }
}
