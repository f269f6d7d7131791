package org.robotui.sim.internal.message;

import java.util.Optional;
import java.util.function.Consumer;
import org.robotui.message.ros.geometry_msgs.PoseStamped;
import org.robotui.message.ros.rosgraph_msgs.Clock;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.SimulatedRobot;
import org.robotui.sim.internal.Simulation;
import org.robotui.sim.internal.model.RobotModel;
import org.robotui.sim.internal.sensor.Lidar;

/**
 * What the simulated robot offers in both generations of ROS: all but goals, tuning and its log. {@link #publish} is
 * for one thread; close it when that thread has ended.
 */
public final class RobotOffer implements AutoCloseable {
  private final Simulation simulation;
  private final RobotClock clock;
  private final Publications publications;
  private final CameraPublisher camera;
  private final DepthPublisher depth;
  private final Optional<LidarPublisher> lidar;
  private final Waypoint waypoint;
  private final Optional<MessageSink<Clock>> simulatedTime;

  /**
   * @param places takes places of others into the map
   * @param clock the time now; told the time of each step
   * @param simTime whether the robot is the source of time for all nodes
   * @param drive takes a goal
   */
  public RobotOffer(MessageNode node, SimulatedRobot robot, Places places, RobotClock clock, boolean simTime,
      Consumer<PoseStamped> drive) {
    simulation = robot.simulation();
    this.clock = clock;
    RobotModel model = robot.model();
    Frames frames = places.frames();
    long stamp = clock.nanos();
    publications = new Publications(node, robot, frames);
    camera = new CameraPublisher(node, simulation.world(), model.lens(), frames);
    simulatedTime = simTime ? Optional.of(node.topic("/clock", Clock.class, TopicKind.CLOCK)) : Optional.empty();
    publications.publishOnce(robot.map(), stamp);
    depth = new DepthPublisher(node, simulation.world(), model.lens(), frames);
    lidar = model.lidar().map(spec -> new LidarPublisher(node, new Lidar(spec, simulation.random(13)), frames));
    new Subscriptions(node, simulation, places, robot.events());
    waypoint = new Waypoint(node, simulation.world(), places, drive, robot.events());
    new Services(node, simulation, new SensorMessages(frames).map(robot.map(), new Stamp(1, stamp)));
  }

  /** What the robot is made of, as URDF. */
  public String description() {
    return publications.description();
  }

  /**
   * Publishes what is due with a step.
   *
   * @param state after the step
   * @param stamp the time now, nanoseconds
   */
  public void publish(long step, RobotState state, long stamp) {
    clock.set(stamp);
    simulatedTime.ifPresent(sink -> sink.send(new Clock(stamp)));
    publications.publish(step, state, stamp);
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
