package org.robotui.ros2;

import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.robotui.ros2.internal.Ros2EnvironmentParser;
import org.robotui.ros2.name.RemapRule;
import org.robotui.ros2.name.Ros2Name;
import org.robotui.rtps.ParticipantSettings;

/**
 * What a context finds around it, as programs of ROS 2 read it from environment variables and the command line.
 *
 * @param domain the number of the domain; those of others do not hear each other
 * @param range how far others are looked for
 * @param staticPeers machines that are asked one by one, whatever the range, unless it is {@link Range#OFF}
 * @param interfaces names or addresses of the network interfaces that are used with {@link Range#SUBNET}; all if empty
 * @param namespace the namespace of nodes
 * @param rules remappings
 * @param arguments the command line's other arguments, in order
 */
public record Ros2Environment(int domain, Range range, List<String> staticPeers, List<String> interfaces,
    Ros2Name namespace, List<RemapRule> rules, List<String> arguments) {

  /** How far others are looked for. */
  public enum Range {
    /** Nobody is looked for. */
    OFF,
    /** This machine; what this library does unless it is told otherwise. */
    LOCALHOST,
    /** All that multicast reaches; what ROS 2 does unless it is told otherwise. */
    SUBNET
  }

  /** Copies the lists and checks the domain. */
  public Ros2Environment {
    Objects.requireNonNull(range, "range");
    Objects.requireNonNull(namespace, "namespace");
    staticPeers = List.copyOf(staticPeers);
    interfaces = List.copyOf(interfaces);
    rules = List.copyOf(rules);
    arguments = List.copyOf(arguments);
    if (domain < 0 || domain > ParticipantSettings.MAX_DOMAIN) {
      throw new IllegalArgumentException(
          "ROS_DOMAIN_ID: " + domain + " is no domain; write 0 to " + ParticipantSettings.MAX_DOMAIN);
    }
  }

  /**
   * Reads environment variables ({@code ROS_DOMAIN_ID}, {@code ROS_LOCALHOST_ONLY},
   * {@code ROS_AUTOMATIC_DISCOVERY_RANGE}, {@code ROS_STATIC_PEERS}) and the command line
   * ({@code --ros-args -r from:=to}). Where nothing says how far others are looked for, it is this machine.
   *
   * @param variables the environment variables
   * @param arguments the command line
   * @return the environment
   * @throws IllegalArgumentException if a variable or argument is malformed; the message names it
   */
  public static Ros2Environment of(Map<String, String> variables, List<String> arguments) {
    return Ros2EnvironmentParser.parse(variables, arguments);
  }

  /**
   * This machine alone, without remappings.
   *
   * @param domain the number of the domain
   * @return the environment
   */
  public static Ros2Environment local(int domain) {
    return new Ros2Environment(domain, Range.LOCALHOST, List.of(), List.of(), Ros2Name.ROOT, List.of(), List.of());
  }

  /**
   * The same with another way to find others.
   *
   * @param reach how far
   * @param peers machines that are asked one by one
   * @param used names or addresses of the network interfaces that are used; all if empty
   * @return the changed environment
   */
  public Ros2Environment within(Range reach, List<String> peers, List<String> used) {
    return new Ros2Environment(domain, reach, peers, used, namespace, rules, arguments);
  }

  /**
   * What the participant of a context is made with.
   *
   * @param name what others see of it; empty as with other programs of ROS 2
   * @return the settings, with the lease that is standard
   */
  public ParticipantSettings participant(Optional<String> name) {
    return Ros2EnvironmentParser.settings(this, name.orElse("/"));
  }
}
