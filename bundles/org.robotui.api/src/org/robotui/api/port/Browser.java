package org.robotui.api.port;

import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Answers what a robot has. Methods may block for a network round trip; they are called on worker threads, never the
 * display thread.
 */
public interface Browser {
  /** What kinds of things a robot has. */
  enum Kind {
    /** Data it sends or takes. */
    TOPIC,
    /** What it can be asked. */
    SERVICE,
    /** Programs it runs. */
    NODE,
    /** Named settings. */
    PARAMETER
  }

  /**
   * A thing that a robot has.
   *
   * @param kind what it is
   * @param name the robot's name for it
   * @param type the robot's name of its type, empty where there is none or it is not known
   */
  record Item(Kind kind, String name, String type) {}

  /**
   * More about a thing.
   *
   * @param item the thing
   * @param facts for example publishers, subscribers, address, by name in a fixed order
   * @param definition the full text of its type, or none with a reason among the facts
   */
  record Description(Item item, Map<String, String> facts, Optional<String> definition) {}

  /**
   * Lists.
   *
   * @param kind what to list
   * @return all of that kind, sorted by name
   * @throws CallException where the robot does not answer
   */
  List<Item> list(Kind kind) throws CallException;

  /**
   * Describes.
   *
   * @param item what to describe
   * @return more about it
   * @throws CallException where the robot does not answer or has it no more
   */
  Description describe(Item item) throws CallException;

  /**
   * Reads a parameter.
   *
   * @param name its name
   * @return its value: Boolean, Long, Double, String, List or Map of these; none where it is not set
   * @throws CallException where the robot does not answer
   */
  Optional<Object> parameter(String name) throws CallException;

  /**
   * Sets a parameter. This is a command: the caller must hold the lease.
   *
   * @param name its name
   * @param value as in {@link #parameter}
   * @throws CallException where the robot does not answer or refuses
   */
  void setParameter(String name, Object value) throws CallException;
}
