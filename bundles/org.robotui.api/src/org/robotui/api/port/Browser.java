package org.robotui.api.port;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.data.record.RecordShape;

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
    PARAMETER,
    /** What it can be told to do, with feedback and result. */
    ACTION,
    /** Programs whose settings can be changed while they run. */
    TUNABLE
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
   * @param shape the form of what goes in: a message, a request, a goal; none where there is none or it is not known
   * @param reply the form of what comes back: a response, a result
   */
  record Description(
      Item item,
      Map<String, String> facts,
      Optional<String> definition,
      Optional<RecordShape> shape,
      Optional<RecordShape> reply) {}

  /**
   * A setting that can be changed while its program runs.
   *
   * @param name its name
   * @param group the names of the groups it lies in, joined by {@code /}; empty at the top
   * @param help a sentence of the robot's makers, may be empty
   * @param value Boolean, Long, Double or String: the kind of the setting
   * @param fallback its default, of the same kind
   * @param least the smallest value, of the same kind, where there is one
   * @param most the largest value, of the same kind, where there is one
   * @param choices the values it may take, where only some are
   */
  record Tunable(
      String name,
      String group,
      String help,
      Object value,
      Object fallback,
      Optional<Object> least,
      Optional<Object> most,
      List<Choice> choices) {
    /**
     * Copies the list.
     *
     * @param name its name
     * @param group the names of its groups
     * @param help a sentence
     * @param value its value
     * @param fallback its default
     * @param least the smallest value
     * @param most the largest value
     * @param choices the values it may take
     */
    public Tunable {
      choices = List.copyOf(choices);
    }
  }

  /**
   * A value that a setting may take.
   *
   * @param name what users read
   * @param value of the kind of the setting
   * @param help a sentence, may be empty
   */
  record Choice(String name, Object value, String help) {}

  /**
   * A program at one end of a topic.
   *
   * @param node its name, as {@link #list} gives it for {@link Kind#NODE}
   * @param topic the name of the topic
   * @param sends true where it publishes, false where it takes
   */
  record Link(String node, String topic, boolean sends) {}

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

  /**
   * Reads the settings of a program that can be changed while it runs.
   *
   * @param item of the kind {@link Kind#TUNABLE}
   * @return its settings in their order
   * @throws CallException where the robot does not answer
   */
  List<Tunable> tunables(Item item) throws CallException;

  /**
   * Changes such settings. This is a command: the caller must hold the lease.
   *
   * @param item of the kind {@link Kind#TUNABLE}
   * @param values new values by name; others stay
   * @return all settings as the program has them now, which may differ from what was asked
   * @throws CallException where the robot does not answer or refuses
   */
  List<Tunable> setTunables(Item item, Map<String, Object> values) throws CallException;

  /**
   * How programs and topics are connected, all with one question to the robot.
   *
   * @return one entry for each program and topic that it sends or takes, in no order
   * @throws CallException where the robot does not answer, or does not know
   */
  default List<Link> links() throws CallException {
    throw new CallException("this kind of robot does not say how its programs are connected");
  }
}
