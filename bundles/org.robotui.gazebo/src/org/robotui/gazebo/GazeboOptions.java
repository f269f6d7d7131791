package org.robotui.gazebo;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ThreadFactory;
import org.robotui.net.process.ThisMachine;

/**
 * Where a node takes part, and as what.
 *
 * @param partition only nodes of the same one see each other
 * @param address the address of this machine in the network of the others. A loopback address limits the node to this
 * machine: it listens on no other one, and hears nobody from elsewhere.
 * @param ports where discovery is
 * @param statistics whether all processes count what they publish; those that do and those that do not are strangers
 * @param threads makes the threads of the node
 */
public record GazeboOptions(String partition, InetAddress address, DiscoveryPorts ports, boolean statistics,
    ThreadFactory threads) {

  /**
   * Where discovery is.
   *
   * @param group the multicast group
   * @param topics the port for topics
   * @param services the port for services
   */
  public record DiscoveryPorts(InetAddress group, int topics, int services) {
    private static final String GROUP = "239.255.0.7";
    private static final int TOPICS = 10317;

    /** The usual ones. */
    public static DiscoveryPorts usual() {
      return of(Map.of());
    }

    private static DiscoveryPorts of(Map<String, String> variables) {
      int topics = port(variables, "DISCOVERY_MSG_PORT", TOPICS);
      int services = port(variables, "DISCOVERY_SRV_PORT", TOPICS + 1);
      return new DiscoveryPorts(group(variables), topics, services == topics ? topics + 1 : services);
    }

    private static InetAddress group(Map<String, String> variables) {
      InetAddress usual = numeric(GROUP).orElseThrow();
      return variable(variables, "DISCOVERY_MULTICAST_IP").flatMap(GazeboOptions::numeric)
          .filter(InetAddress::isMulticastAddress).orElse(usual);
    }

    private static int port(Map<String, String> variables, String name, int otherwise) {
      return variable(variables, name).filter(text -> text.matches("[0-9]{1,5}")).map(Integer::parseInt)
          .filter(port -> port > 0 && port < 1 << Short.SIZE).orElse(otherwise);
    }
  }

  /**
   * As Gazebo itself takes them from the environment: {@code GZ_PARTITION}, {@code GZ_IP}, {@code GZ_DISCOVERY_...} and
   * {@code GZ_TRANSPORT_TOPIC_STATISTICS}, or {@code IGN_} instead of {@code GZ_}. Without {@code GZ_IP} a node is
   * limited to this machine.
   *
   * @param variables those of the environment
   * @param threads makes the threads of the node
   * @return the options
   */
  public static GazeboOptions of(Map<String, String> variables, ThreadFactory threads) {
    return new GazeboOptions(variable(variables, "PARTITION").orElseGet(GazeboOptions::usualPartition),
        variable(variables, "IP").flatMap(GazeboOptions::numeric).orElseGet(InetAddress::getLoopbackAddress),
        DiscoveryPorts.of(variables), variable(variables, "TRANSPORT_TOPIC_STATISTICS").equals(Optional.of("1")),
        threads);
  }

  /** The name of this machine and of the user. */
  private static String usualPartition() {
    return ThisMachine.name() + ":" + System.getProperty("user.name", "");
  }

  private static Optional<String> variable(Map<String, String> variables, String name) {
    return Optional.ofNullable(variables.get("GZ_" + name)).or(() -> Optional.ofNullable(variables.get("IGN_" + name)))
        .filter(text -> !text.isBlank());
  }

  /**
   * An address as it is written, without asking anybody for a name.
   *
   * @param text such as 192.168.0.1
   * @return the address, or none where the text is none of version 4
   */
  public static Optional<InetAddress> numeric(String text) {
    try {
      return text.matches("[0-9]{1,3}(\\.[0-9]{1,3}){3}") ? Optional.of(InetAddress.getByName(text)) : Optional.empty();
    } catch (UnknownHostException e) {
      return Optional.empty();
    }
  }

  /**
   * The same in another partition.
   *
   * @param other its name
   * @return the options
   */
  public GazeboOptions inPartition(String other) {
    return new GazeboOptions(other, address, ports, statistics, threads);
  }

  /**
   * The same at another address.
   *
   * @param other of this machine
   * @return the options
   */
  public GazeboOptions at(InetAddress other) {
    return new GazeboOptions(partition, other, ports, statistics, threads);
  }
}
