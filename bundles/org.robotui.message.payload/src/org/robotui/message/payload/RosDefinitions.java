package org.robotui.message.payload;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.message.Generation;
import org.robotui.message.LocalDefinitions;
import org.robotui.message.MessageRegistry;
import org.robotui.message.MessageSchema;
import org.robotui.message.SchemaLookup;
import org.robotui.message.ServiceSchema;

/** Definitions of both generations of ROS: those that are shipped, and those of this machine. Safe for all threads. */
public final class RosDefinitions {
  private final Map<Generation, MessageRegistry> registries;

  /**
   * Knows the types that are shipped and those of this machine.
   *
   * @param environment the environment variables
   */
  public RosDefinitions(Map<String, String> environment) {
    this.registries = Map.of(
        Generation.ROS1, new MessageRegistry(LocalDefinitions.fromEnvironment(environment), Generation.ROS1),
        Generation.ROS2, new MessageRegistry(LocalDefinitions.ofRos2(List.of(), environment), Generation.ROS2));
  }

  /**
   * A definition that is known here; files may be read for that.
   *
   * @param type a type of ROS
   * @param generation whose version of it
   * @return the definition, or why there is none
   */
  public SchemaLookup<MessageSchema> of(String type, Generation generation) {
    return registries.get(generation).message(type);
  }

  /**
   * The definition of a service of ROS 2 that is known here; files may be read for that.
   *
   * @param type a type of services, of two parts or three
   * @return the definition, or why there is none
   */
  public SchemaLookup<ServiceSchema> ros2Service(String type) {
    return registries.get(Generation.ROS2).service(type);
  }

  /**
   * A definition of the generation that writes the name of the type so; else of the other one.
   *
   * @param type a type of ROS, of two parts or three
   * @return none where neither is known
   */
  public Optional<MessageSchema> find(String type) {
    boolean three = isOfThreeParts(type);
    return found(type, three ? Generation.ROS2 : Generation.ROS1)
        .or(() -> found(type, three ? Generation.ROS1 : Generation.ROS2));
  }

  private Optional<MessageSchema> found(String type, Generation generation) {
    return of(type, generation) instanceof SchemaLookup.Found<MessageSchema> found ? Optional.of(found.schema())
        : Optional.empty();
  }

  /**
   * Whether the name of a type is of three parts, as in ROS 2.
   *
   * @param type its name
   * @return true for such as {@code std_msgs/msg/Header}
   */
  public static boolean isOfThreeParts(String type) {
    return type.indexOf('/') != type.lastIndexOf('/');
  }
}
