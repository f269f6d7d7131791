package org.robotui.sim.internal.ros2;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SequencedMap;
import java.util.concurrent.ThreadFactory;
import org.robotui.ros2.Ros2Context;
import org.robotui.ros2.Ros2Environment;
import org.robotui.ros2.Ros2Options;
import org.robotui.rtps.Participant;
import org.robotui.sim.internal.Face;
import org.robotui.sim.internal.SimulatedRobot;
import org.robotui.sim.internal.ros.RosOptions;

/** The robot as a node of ROS 2, in a domain of this machine. */
public final class Ros2Face implements Face {
  private final Ros2Context context;
  private final RosOptions options;
  private final int domain;
  private final ThreadFactory threads;
  private Optional<Ros2Robot> robot = Optional.empty();

  private Ros2Face(Ros2Context context, RosOptions options, int domain, ThreadFactory threads) {
    this.context = context;
    this.options = options;
    this.domain = domain;
    this.threads = threads;
  }

  /**
   * Takes part in a domain.
   *
   * @param options names and remappings; private parameters are those of ROS 1 alone
   * @throws IOException if there is no free domain, or its ports are taken
   */
  public static Ros2Face open(RosOptions options, DomainOptions domain, ThreadFactory threads) throws IOException {
    Ros2Environment environment = environment(options, domain);
    Ros2Options standard = Ros2Options.standard(threads);
    if (domain.domain().isPresent()) {
      return new Ros2Face(Ros2Context.open(environment, standard), options, environment.domain(), threads);
    }
    Participant participant = FreeDomain.enter(environment, threads);
    return new Ros2Face(Ros2Context.on(participant, environment, standard), options,
        participant.info().domain().orElseThrow(), threads);
  }

  private static Ros2Environment environment(RosOptions options, DomainOptions domain) {
    List<String> arguments = new ArrayList<>(List.of("--ros-args"));
    options.arguments().stream().filter(each -> !each.startsWith("_"))
        .forEach(each -> arguments.addAll(List.of("-r", each)));
    if (!options.namespace().isEmpty()) {
      arguments.addAll(List.of("-r", "__ns:=/" + options.namespace()));
    }
    return Ros2Environment.of(Map.of("ROS_DOMAIN_ID", "" + domain.domain().orElse(0),
        "ROS_AUTOMATIC_DISCOVERY_RANGE", domain.subnet() ? "SUBNET" : "LOCALHOST"), arguments);
  }

  @Override
  public void show(SimulatedRobot shown, long stamp) {
    robot = Optional.of(new Ros2Robot(context.node(options.name()), shown, options.simTime(), stamp, threads));
  }

  @Override
  public void step(long step, long stamp) {
    robot.ifPresent(shown -> shown.publish(step, stamp));
  }

  @Override
  public SequencedMap<String, String> addresses() {
    SequencedMap<String, String> variables = new LinkedHashMap<>();
    variables.put("ROS_DOMAIN_ID", "" + domain);
    return variables;
  }

  @Override
  public void close() {
    robot.ifPresent(Ros2Robot::close);
    context.close();
  }
}
