package org.robotui.sim;

import java.net.URI;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import org.robotui.sim.internal.model.RobotModel;
import org.robotui.sim.internal.ros.RosOptions;

/**
 * What the demo robot is started with.
 *
 * @param robot which robot
 * @param speaks the frameworks in which it appears, at least one
 * @param ros for ROS
 * @param playerPort of the Player server; 0 for a free one
 * @param lcmUrl where LCM's messages go; empty for multicast on a free port of this machine
 * @param lcmTypes the folder with the types of LCM's messages
 * @param seed of all noise
 * @param speedFactor how many times faster than real the robot lives
 * @param parent a process with which the robot ends
 * @param swarm how many cheap robots to start in place of one; 0 for the one
 */
record Options(
    RobotModel robot,
    Set<Speech> speaks,
    RosOptions ros,
    int playerPort,
    Optional<URI> lcmUrl,
    Optional<Path> lcmTypes,
    long seed,
    double speedFactor,
    OptionalLong parent,
    int swarm) {
  static final String USAGE =
      """
      Usage: org.robotui.sim.Main [OPTION]... [FROM:=TO]... [_PARAMETER:=VALUE]...
        --robot NAME        natalie, the default, or keira
        --speak LIST        ros, the default, player, lcm, or several with commas between
        --seed N            seed of all noise (1)
        --speed-factor X    run X times faster than real (1)
        --parent PID        end when that process has gone
        --help              show this text
      For ROS:
        --port N            port of the embedded ROS master on loopback; 0, the default, takes a free one
        --real-master URI   use this master instead of an embedded one
        --namespace NS      put the robot's names and frames into a namespace
        --name NAME         name of the node (robot)
        --sim-time          publish /clock and set /use_sim_time
        --swarm N           N cheap robots in namespaces r1, r2 and so on, in place of the one
      For Player:
        --player-port N     port of the server on loopback; 0, the default, takes a free one
      For LCM:
        --lcm-types FOLDER  the .lcm files of the package robotui
        --lcm-url URL       where messages go, in place of multicast on a free port of this machine
      Prints a line NAME=VALUE for each variable that clients need when everything is offered. Ends on SIGTERM.
      """;

  /** A framework in which the robot can appear. */
  enum Speech {
    ROS,
    PLAYER,
    LCM
  }

  Options {
    speaks = Set.copyOf(new LinkedHashSet<>(speaks));
  }

  /**
   * Reads a command line.
   *
   * @throws IllegalArgumentException naming what is wrong and what was expected
   */
  static Options parse(List<String> arguments) {
    return new OptionParser(arguments).parse();
  }
}
