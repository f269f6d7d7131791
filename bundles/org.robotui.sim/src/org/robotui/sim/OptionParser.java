package org.robotui.sim;

import java.net.URI;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.OptionalLong;
import java.util.Set;
import org.robotui.sim.Options.Speech;
import org.robotui.sim.internal.model.RobotModel;
import org.robotui.sim.internal.model.Robots;
import org.robotui.sim.internal.ros.RosOptions;
import org.robotui.sim.internal.ros2.DomainOptions;
import org.robotui.sim.internal.swarm.Swarm;

/** Takes the arguments of a command line from left to right. */
final class OptionParser {
  private static final int PORTS = 65535;

  private final List<String> arguments;
  private final List<String> rosArguments = new ArrayList<>();
  private int next;
  private RobotModel robot = Robots.NATALIE;
  private Set<Speech> speaks = EnumSet.of(Speech.ROS);
  private int port;
  private String namespace = "";
  private String name = "robot";
  private Optional<URI> realMaster = Optional.empty();
  private boolean simTime;
  private OptionalInt domain = OptionalInt.empty();
  private boolean subnet;
  private int playerPort;
  private int carmenPort;
  private int yarpPort;
  private int smartsoftPort;
  private int robletsPort;
  private int roboframePort;
  private Optional<URI> lcmUrl = Optional.empty();
  private Optional<Path> lcmTypes = Optional.empty();
  private long seed = 1;
  private double speedFactor = 1;
  private OptionalLong parent = OptionalLong.empty();
  private int swarm;
  private boolean boat;
  private boolean humanoid;
  private Optional<Path> urdf = Optional.empty();

  OptionParser(List<String> arguments) {
    this.arguments = arguments;
  }

  Options parse() {
    while (next < arguments.size()) {
      take(arguments.get(next++));
    }
    if (speaks.contains(Speech.LCM) && lcmTypes.isEmpty()) {
      throw new IllegalArgumentException(
          "--speak lcm needs --lcm-types, the folder with the .lcm files of the package robotui");
    }
    if (humanoid && urdf.isEmpty()) {
      throw new IllegalArgumentException("--humanoid needs --urdf, the file that says how it is built");
    }
    RosOptions ros = new RosOptions(port, namespace, name, realMaster, simTime, rosArguments);
    return new Options(robot, speaks, ros, new DomainOptions(domain, subnet), playerPort, carmenPort, yarpPort,
        smartsoftPort, robletsPort, roboframePort, lcmUrl, lcmTypes, seed, speedFactor, parent, swarm, boat,
        urdf.filter(file -> humanoid));
  }

  private void take(String option) {
    switch (option) {
      case "--robot" -> robot = robot(option);
      case "--speak" -> speaks = speaks(option);
      case "--port" -> port = (int) whole(option, 0, PORTS);
      case "--real-master" -> realMaster = Optional.of(master(option));
      case "--namespace" -> namespace = value(option).replaceAll("^/+|/+$", "");
      case "--name" -> name = value(option);
      case "--sim-time" -> simTime = true;
      case "--domain" -> domain = OptionalInt.of((int) whole(option, 0, DomainOptions.MOST));
      case "--subnet" -> subnet = true;
      case "--player-port" -> playerPort = (int) whole(option, 0, PORTS);
      case "--carmen-port" -> carmenPort = (int) whole(option, 0, PORTS);
      case "--yarp-port" -> yarpPort = (int) whole(option, 0, PORTS);
      case "--smartsoft-port" -> smartsoftPort = (int) whole(option, 0, PORTS);
      case "--roblets-port" -> robletsPort = (int) whole(option, 0, PORTS);
      case "--boat" -> boat = true;
      case "--roboframe-port" -> roboframePort = (int) whole(option, 0, PORTS);
      case "--lcm-url" -> lcmUrl = Optional.of(URI.create(value(option)));
      case "--humanoid" -> humanoid = true;
      case "--urdf" -> urdf = Optional.of(Path.of(value(option)));
      case "--lcm-types" -> lcmTypes = Optional.of(Path.of(value(option)));
      case "--seed" -> seed = whole(option, Long.MIN_VALUE, Long.MAX_VALUE);
      case "--speed-factor" -> speedFactor = factor(option);
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

  private RobotModel robot(String option) {
    String wanted = value(option);
    return Robots.named(wanted)
        .orElseThrow(() -> new IllegalArgumentException(
            option + " knows no robot '" + wanted + "', but " + String.join(", ", Robots.names())));
  }

  private Set<Speech> speaks(String option) {
    EnumSet<Speech> all = EnumSet.noneOf(Speech.class);
    for (String word : value(option).split(",")) {
      all.add(speech(option, word.strip()));
    }
    return all;
  }

  private static Speech speech(String option, String word) {
    try {
      return Speech.valueOf(word.toUpperCase(Locale.ROOT));
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException(
          option + " knows ros, ros2, player, lcm, carmen, yarp, smartsoft and roboframe, not '" + word + "'",
          e);
    }
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

  private URI master(String option) {
    URI uri = URI.create(value(option));
    if (!"http".equals(uri.getScheme()) || uri.getHost() == null) {
      throw new IllegalArgumentException(option + " needs an address such as http://127.0.0.1:11311");
    }
    return uri;
  }
}
