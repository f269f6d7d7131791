package org.robotui.sim.internal.ros;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Optional;
import java.util.SequencedMap;
import java.util.concurrent.ThreadFactory;
import org.robotui.ros.GraphName;
import org.robotui.ros.NodeOptions;
import org.robotui.ros.RosNode;
import org.robotui.ros.XmlRpcValue;
import org.robotui.sim.internal.Face;
import org.robotui.sim.internal.Settings;
import org.robotui.sim.internal.SimulatedRobot;

/** The robot as a node of ROS, with a master of its own unless there is one. */
public final class RosFace implements Face {
  private static final Duration REGISTRATION = Duration.ofSeconds(20);

  private final DemoMaster master;
  private final RosNode node;
  private final RosOptions options;
  private Optional<RobotNode> robot = Optional.empty();

  private RosFace(DemoMaster master, RosNode node, RosOptions options) {
    this.master = master;
    this.node = node;
    this.options = options;
  }

  /**
   * Registers a node.
   *
   * @param gone called when the node is told to shut down
   * @throws IOException if there is no port for the master, or none answers
   */
  public static RosFace open(RosOptions options, ThreadFactory threads, Runnable gone) throws IOException {
    DemoMaster master = DemoMaster.open(options, threads);
    RosNode node = RosNode.open(master.environment(arguments(options)), GraphName.of(options.name()),
        NodeOptions.standard(threads));
    RosFace face = new RosFace(master, node, options);
    try {
      face.awaitMaster();
    } catch (IOException | RuntimeException e) {
      face.close();
      throw e;
    }
    node.whenClosed().thenRun(gone);
    return face;
  }

  private static List<String> arguments(RosOptions options) {
    List<String> arguments = new ArrayList<>(options.arguments());
    if (!options.namespace().isEmpty()) {
      arguments.add("__ns:=/" + options.namespace());
    }
    return arguments;
  }

  /** The first time for the parameters of the command line, which the robot reads; then for all it advertises. */
  private void awaitMaster() throws IOException {
    if (!node.awaitRegistered(REGISTRATION)) {
      throw new IOException(
          "the master at " + master.uri() + " did not take the robot within " + REGISTRATION.toSeconds() + " s");
    }
  }

  /** Reads the limits of the drive from the node's parameters. Waits for the master to answer. */
  @Override
  public Settings adjust(Settings settings) {
    if (options.simTime()) {
      node.parameters().set("/use_sim_time", new XmlRpcValue.Bool(true));
    }
    return settings.withLimits(new LimitParameters(node.parameters()).read(settings.limits()));
  }

  @Override
  public void show(SimulatedRobot shown, long stamp) throws IOException {
    robot = Optional.of(new RobotNode(node, shown, options.simTime(), stamp));
    awaitMaster();
  }

  @Override
  public void step(long step, long stamp) {
    robot.ifPresent(shown -> shown.publish(step, stamp));
  }

  @Override
  public SequencedMap<String, String> addresses() {
    SequencedMap<String, String> variables = new LinkedHashMap<>();
    variables.put("ROS_MASTER_URI", master.text());
    return variables;
  }

  @Override
  public void close() {
    robot.ifPresent(RobotNode::close);
    node.close();
    master.close();
  }
}
