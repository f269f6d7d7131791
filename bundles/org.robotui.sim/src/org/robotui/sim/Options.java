package org.robotui.sim;

import java.net.URI;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import org.robotui.sim.internal.swarm.Swarm;

/**
 * What the demo robot is started with.
 *
 * @param port of the embedded master; 0 for a free one
 * @param namespace of the robot, empty for none
 * @param name of the node
 * @param seed of all noise
 * @param speedFactor how many times faster than real the robot lives
 * @param realMaster a master to be used in place of the embedded one
 * @param simTime whether {@code /clock} is published for all nodes
 * @param parent a process with which the robot ends
 * @param swarm how many cheap robots to start in place of one; 0 for the one
 * @param rosArguments remappings and private parameters, as every ROS program takes them
 */
record Options(
    int port,
    String namespace,
    String name,
    long seed,
    double speedFactor,
    Optional<URI> realMaster,
    boolean simTime,
    OptionalLong parent,
    int swarm,
    List<String> rosArguments) {
  static final String USAGE =
      """
      Usage: org.robotui.sim.Main [OPTION]... [FROM:=TO]... [_PARAMETER:=VALUE]...
        --port N            port of the embedded ROS master on loopback; 0, the default, takes a free one
        --real-master URI   use this master instead of an embedded one
        --namespace NS      put the robot's names and frames into a namespace
        --name NAME         name of the node (robot)
        --seed N            seed of all noise (1)
        --speed-factor X    run X times faster than real (1)
        --sim-time          publish /clock and set /use_sim_time
        --swarm N           N cheap robots in namespaces r1, r2 and so on, in place of the one
        --parent PID        end when that process has gone
        --help              show this text
      Prints ROS_MASTER_URI=URI when everything is advertised. Ends on SIGTERM.
      """;

  Options {
    rosArguments = List.copyOf(rosArguments);
  }

  /**
   * Reads a command line.
   *
   * @throws IllegalArgumentException naming what is wrong and what was expected
   */
  static Options parse(List<String> arguments) {
    return new Parser(arguments).parse();
  }

  /** Takes the arguments from left to right. */
  private static final class Parser {
    private final List<String> arguments;
    private final List<String> rosArguments = new ArrayList<>();
    private int next;
    private int port;
    private String namespace = "";
    private String name = "robot";
    private long seed = 1;
    private double speedFactor = 1;
    private Optional<URI> realMaster = Optional.empty();
    private boolean simTime;
    private OptionalLong parent = OptionalLong.empty();
    private int swarm;

    Parser(List<String> arguments) {
      this.arguments = arguments;
    }

    Options parse() {
      while (next < arguments.size()) {
        take(arguments.get(next++));
      }
      return new Options(
          port, namespace, name, seed, speedFactor, realMaster, simTime, parent, swarm, rosArguments);
    }

    private void take(String option) {
      switch (option) {
        case "--port" -> port = (int) whole(option, 0, 65535);
        case "--real-master" -> realMaster = Optional.of(uri(option));
        case "--namespace" -> namespace = trimmed(value(option));
        case "--name" -> name = value(option);
        case "--seed" -> seed = whole(option, Long.MIN_VALUE, Long.MAX_VALUE);
        case "--speed-factor" -> speedFactor = factor(option);
        case "--sim-time" -> simTime = true;
        case "--parent" -> parent = OptionalLong.of(whole(option, 1, Long.MAX_VALUE));
        case "--swarm" -> swarm = (int) whole(option, 1, Swarm.MOST);
        default -> other(option);
      }
    }

    private void other(String option) {
      if (option.startsWith("-") || !option.contains(":=")) {
        throw new IllegalArgumentException("unknown option '" + option + "'");
      }
      rosArguments.add(option);
    }

    private String value(String option) {
      if (next >= arguments.size()) {
        throw new IllegalArgumentException(option + " needs a value");
      }
      return arguments.get(next++);
    }

    private static String trimmed(String namespace) {
      return namespace.replaceAll("^/+|/+$", "");
    }

    private long whole(String option, long least, long most) {
      String text = value(option);
      try {
        long number = Long.parseLong(text);
        if (number >= least && number <= most) {
          return number;
        }
      } catch (NumberFormatException e) {
        throw new IllegalArgumentException(option + " needs a whole number, not '" + text + "'", e);
      }
      throw new IllegalArgumentException(option + " must be from " + least + " to " + most + ", not " + text);
    }

    private double factor(String option) {
      String text = value(option);
      try {
        double number = Double.parseDouble(text);
        if (number >= 0.01 && number <= 50) {
          return number;
        }
      } catch (NumberFormatException e) {
        throw new IllegalArgumentException(option + " needs a number, not '" + text + "'", e);
      }
      throw new IllegalArgumentException(option + " must be from 0.01 to 50, not " + text);
    }

    private URI uri(String option) {
      URI uri = URI.create(value(option));
      if (!"http".equals(uri.getScheme()) || uri.getHost() == null) {
        throw new IllegalArgumentException(option + " needs an address such as http://127.0.0.1:11311");
      }
      return uri;
    }
  }
}
