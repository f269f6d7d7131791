package org.robotui.sim.internal.ros;

import java.net.URI;
import java.util.List;
import java.util.Optional;

/**
 * What the ROS face is started with.
 *
 * @param port of the embedded master; 0 for a free one
 * @param namespace of the robot, empty for none
 * @param name of the node
 * @param realMaster a master to be used in place of the embedded one
 * @param simTime whether {@code /clock} is published for all nodes
 * @param arguments remappings and private parameters, as every ROS program takes them
 */
public record RosOptions(int port, String namespace, String name, Optional<URI> realMaster, boolean simTime,
    List<String> arguments) {
  public RosOptions {
    arguments = List.copyOf(arguments);
  }
}
