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
import org.robotui.sim.internal.ros2.DomainOptions;

/**
 * What the demo robot is started with.
 *
 * @param robot which robot
 * @param speaks the frameworks in which it appears, at least one
 * @param ros names, time and the master of ROS; ROS 2 has all of it but the master
 * @param domain for ROS 2
 * @param playerPort of the Player server; 0 for a free one
 * @param carmenPort of CARMEN's central; 0 for a free one
 * @param yarpPort of YARP's name server; 0 for a free one
 * @param smartsoftPort of SmartSoft's naming service; 0 for a free one
 * @param robletsPort of the brain of roblets; 0 for a free one
 * @param roboframePort of the application of RoboFrame; 0 for a free one
 * @param lcmUrl where LCM's messages go; empty for multicast on a free port of this machine
 * @param lcmTypes the folder with the types of LCM's messages
 * @param seed of all noise
 * @param speedFactor how many times faster than real the robot lives
 * @param parent a process with which the robot ends
 * @param swarm how many cheap robots to start in place of one; 0 for the one
 * @param boat whether to start a boat of roblets in place of the robot
 * @param humanoid the URDF of a humanoid of YARP to start in place of the robot
 */
record Options(
    RobotModel robot,
    Set<Speech> speaks,
    RosOptions ros,
    DomainOptions domain,
    int playerPort,
    int carmenPort,
    int yarpPort,
    int smartsoftPort,
    int robletsPort,
    int roboframePort,
    Optional<URI> lcmUrl,
    Optional<Path> lcmTypes,
    long seed,
    double speedFactor,
    OptionalLong parent,
    int swarm,
    boolean boat,
    Optional<Path> humanoid) {
  static final String USAGE =
      """
      Usage: org.robotui.sim.Main [OPTION]... [FROM:=TO]... [_PARAMETER:=VALUE]...
        --robot NAME        natalie, the default, or keira
        --speak LIST        ros, the default, ros2, player, lcm,
                            carmen, yarp, smartsoft, roblets, roboframe,
                            or several with commas between
        --seed N            seed of all noise (1)
        --speed-factor X    run X times faster than real (1)
        --parent PID        end when that process has gone
        --help              show this text
      For ROS 1:
        --port N            port of the embedded ROS master on loopback; 0, the default, takes a free one
        --real-master URI   use this master instead of an embedded one
        --swarm N           N cheap robots in namespaces r1, r2 and so on, in place of the one
      For ROS 2:
        --domain N          the domain, 0 to 232; without it one in which nobody else is on this machine
        --subnet            let other machines reach it
      For both:
        --namespace NS      put the robot's names and frames into a namespace
        --name NAME         name of the node (robot)
        --sim-time          publish /clock, and set /use_sim_time of ROS 1
      For Player:
        --player-port N     port of the server on loopback; 0, the default, takes a free one
      For CARMEN:
        --carmen-port N     port of the central on loopback; 0, the default, takes a free one
      For YARP:
        --yarp-port N       port of the name server on loopback; 0, the default, takes a free one
        --humanoid          a humanoid with a control board for each group of its SRDF, in place of the robot
        --urdf FILE         how it is built; the SRDF of the same name lies beside it
      For SmartSoft:
        --smartsoft-port N  port of the naming service on loopback; 0, the default, takes a free one
      For roblets:
        --roblets-port N    port of the brain on loopback; 0, the default, takes a free one
        --boat              a boat that sails from mark to mark, in place of the robot
      For RoboFrame:
        --roboframe-port N  port of the application on loopback; 0, the default, takes a free one
      For LCM:
        --lcm-types FOLDER  the .lcm files of the package robotui
        --lcm-url URL       where messages go, in place of multicast on a free port of this machine
      Prints a line NAME=VALUE for each variable that clients need when everything is offered. Ends on SIGTERM.
      """;

  /** A framework in which the robot can appear. */
  enum Speech {
    ROS,
    ROS2,
    PLAYER,
    LCM,
    CARMEN,
    YARP,
    SMARTSOFT,
    ROBLETS,
    ROBOFRAME
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
