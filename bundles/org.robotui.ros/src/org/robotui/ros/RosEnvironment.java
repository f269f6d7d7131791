package org.robotui.ros;

import java.net.URI;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/**
 * What a node finds around it: the master's address, its own address, its namespace and its remappings, from the
 * environment variables and the command line as every ROS program reads them.
 *
 * @param masterUri the master's address
 * @param host the address or host name to announce to peers; empty announces, and listens on, loopback only
 * @param namespace the namespace of relative names
 * @param nodeName the name given on the command line ({@code __name:=}), if any
 * @param remappings from name to name as the user wrote them
 * @param parameters private parameters given on the command line ({@code _name:=value}), without the underscore
 * @param arguments the command line's other arguments, in order
 */
public record RosEnvironment(URI masterUri, Optional<String> host, GraphName namespace, Optional<GraphName> nodeName,
    Map<String, String> remappings, Map<String, XmlRpcValue> parameters, List<String> arguments) {

  /** Copies the collections and checks that nothing is missing. */
  public RosEnvironment {
    Objects.requireNonNull(masterUri, "masterUri");
    Objects.requireNonNull(host, "host");
    Objects.requireNonNull(namespace, "namespace");
    Objects.requireNonNull(nodeName, "nodeName");
    remappings = Map.copyOf(remappings);
    parameters = Map.copyOf(parameters);
    arguments = List.copyOf(arguments);
  }

  /**
   * Reads environment variables and command line. {@code ROS_HOSTNAME} wins over {@code ROS_IP}, and the command line
   * ({@code __master:= __hostname:= __ip:= __ns:= __name:= _param:= from:=to}) over both.
   *
   * @param variables the environment variables
   * @param arguments the command line
   * @return the environment
   * @throws IllegalArgumentException if a variable or argument is malformed; the message names it
   */
  public static RosEnvironment of(Map<String, String> variables, List<String> arguments) {
    return EnvironmentParser.parse(variables, arguments);
  }

  /**
   * An environment without remappings on loopback.
   *
   * @param masterUri the master's address
   * @return the environment
   */
  public static RosEnvironment of(URI masterUri) {
    return new RosEnvironment(masterUri, Optional.empty(), GraphName.ROOT, Optional.empty(), Map.of(), Map.of(),
        List.of());
  }

  /**
   * The same environment with another host to announce.
   *
   * @param newHost an address or a host name by which peers reach this machine
   * @return the changed environment
   */
  public RosEnvironment withHost(String newHost) {
    return new RosEnvironment(masterUri, Optional.of(newHost), namespace, nodeName, remappings, parameters, arguments);
  }
}
