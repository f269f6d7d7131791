package org.robotui.sim.internal.ros;

import java.util.Optional;
import org.robotui.ros.Publisher;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.RosNode;
import org.robotui.ros.XmlRpcValue;
import org.robotui.ros.msgs.rosgraph_msgs.Clock;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.Settings;
import org.robotui.sim.internal.Simulation;
import org.robotui.sim.internal.camera.Lens;
import org.robotui.sim.internal.sensor.Lidar;
import org.robotui.sim.internal.sensor.LidarSpec;
import org.robotui.sim.internal.world.GridMap;
import org.robotui.sim.internal.world.MapRasterizer;
import org.robotui.sim.internal.world.World;

/** The simulated robot as a ROS node. {@link #step} is for one thread; close it when that thread has ended. */
public final class RobotNode implements AutoCloseable {
  private static final double MAP_RESOLUTION = 0.05;

  private final RosNode node;
  private final Simulation simulation;
  private final RobotClock clock;
  private final Publications publications;
  private final CameraPublisher camera;
  private final DepthPublisher depth;
  private final LidarPublisher lidar;
  private final MoveBase moveBase;
  private final Waypoint waypoint;
  private final Optional<Publisher<Clock>> simulatedTime;
  private long steps;

  private RobotNode(RosNode node, World world, Settings settings, boolean simTime, long stamp) {
    this.node = node;
    clock = new RobotClock(stamp);
    Frames frames = new Frames(node.name().namespace().text().substring(1));
    EventLog events = new EventLog(node, clock::nanos);
    GridMap map = new MapRasterizer(world, MAP_RESOLUTION, settings.laser().height()).rasterize();
    simulation = new Simulation(world, map, settings, events);
    publications = new Publications(node, simulation, frames);
    camera = new CameraPublisher(node, world, Lens.DEMO, frames);
    simulatedTime = simTime
        ? Optional.of(node.publisher("/clock", Clock.CODEC, PublisherOptions.standard()))
        : Optional.empty();
    node.parameters().set("robot_description", XmlRpcValue.of(publications.description(Lens.DEMO, frames)));
    publications.publishOnce(map, Lens.DEMO, frames, stamp);
    depth = new DepthPublisher(node, world, Lens.DEMO, frames);
    lidar = new LidarPublisher(node, new Lidar(LidarSpec.DEMO, simulation.random(13)), frames);
    Places places = new Places(frames, simulation::state);
    new Subscriptions(node, simulation, places, events);
    moveBase = new MoveBase(node, simulation, places, clock, events);
    waypoint = new Waypoint(node, world, places, moveBase::drive, events);
    new Tuner(node, simulation);
    new Services(node, simulation, new SensorMessages(frames).map(map, new Stamp(1, stamp)));
  }

  /**
   * Puts a robot on a node. Waits for the master to answer about the parameters.
   *
   * @param node taken over: closed with the robot
   * @param simTime whether the robot is the source of time for all nodes
   * @param stamp the time now, nanoseconds
   */
  public static RobotNode start(RosNode node, World world, Settings settings, boolean simTime, long stamp) {
    if (simTime) {
      node.parameters().set("/use_sim_time", new XmlRpcValue.Bool(true));
    }
    Settings used = settings.withLimits(new LimitParameters(node.parameters()).read(settings.limits()));
    return new RobotNode(node, world, used, simTime, stamp);
  }

  /**
   * Advances the robot by one step and publishes what is due with it.
   *
   * @param stamp the time now, nanoseconds
   */
  public void step(long stamp) {
    clock.set(stamp);
    simulation.step();
    steps++;
    RobotState state = simulation.state();
    simulatedTime.ifPresent(publisher -> publisher.publish(new Clock(stamp)));
    publications.publish(steps, state, stamp);
    moveBase.publish(steps, state, stamp);
    waypoint.publish(steps);
    camera.publish(steps, state, stamp);
    depth.publish(steps, state, stamp);
    lidar.publish(steps, simulation.present(), state, stamp);
  }

  /** The robot's state; for any thread. */
  public RobotState state() {
    return simulation.state();
  }

  @Override
  public void close() {
    camera.close();
    depth.close();
    lidar.close();
    node.close();
  }
}
