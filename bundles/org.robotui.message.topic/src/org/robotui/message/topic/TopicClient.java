package org.robotui.message.topic;

import java.util.Optional;
import java.util.function.Consumer;
import org.robotui.api.replay.StreamHistory;
import org.robotui.message.DynamicMessage;
import org.robotui.message.MessageSchema;
import org.robotui.message.SchemaLookup;
import org.robotui.message.data.MessageForm;
import org.robotui.message.ros.visualization_msgs.GetInteractiveMarkersResponse;

/**
 * What a robotics framework gives of its own: topics that carry messages. Topics have global names that begin with a
 * slash; types have names of two parts, such as {@code sensor_msgs/LaserScan}, also where the framework writes three.
 * Any thread may call it; no call waits for the robot.
 */
public interface TopicClient {

  /**
   * Whether the messages of a topic have a definition of ROS. Others are read by the names of their fields alone
   * ({@code MessageForm.ByFields}).
   *
   * @param topic its name
   * @return true unless something else defines them
   */
  default boolean isDefined(String topic) {
    return true;
  }

  /**
   * Whether programs of the framework can have a type. Common types of RoboFrame are known here beside those of ROS,
   * but no node of ROS knows them.
   *
   * @param type its name
   * @return false where a message of this type would be heard by nobody
   */
  default boolean canCarry(String type) {
    return !type.startsWith("roboframe/");
  }

  /**
   * Receives the messages of a topic, from now on and from all who publish it.
   *
   * @param <M> the Java value of a message
   * @param topic its name
   * @param type the type of its messages
   * @param form what they are read as
   * @param listener is told of each message, on a thread of the framework
   * @return the subscription; to be closed before the client
   */
  <M> TopicSubscription subscribe(String topic, String type, MessageForm<M> form, TopicListener<M> listener);

  /**
   * All messages of a topic, where this is no robot but a recording.
   *
   * @param <M> the Java value of a message
   * @param port the name of the port to which the topic goes
   * @param topic its name
   * @param type the type of its messages
   * @param form what they are read as
   * @param conversion makes values of them
   * @return where the port can be read by its name; none where messages are known only as they come
   */
  default <M> Optional<StreamHistory> history(String port, String topic, String type, MessageForm<M> form,
      HistoryConversion<M> conversion) {
    return Optional.empty();
  }

  /**
   * Offers a topic for commands. As little as possible is entrusted to a network that stalls: what comes late does
   * harm. Nothing is kept for subscribers that come later.
   *
   * @param <M> the record of a message
   * @param topic its name
   * @param type the type of its messages
   * @param form the record
   * @param mostWaiting how many messages may wait for each subscriber; the oldest go
   * @return what says them
   */
  <M extends Record> TopicPublisher<M> commands(String topic, String type, Class<M> form, int mostWaiting);

  /**
   * Offers a topic for single messages of any type. Nothing is kept for subscribers that come later.
   *
   * @param topic its name
   * @param schema the type of its messages
   * @return what says them
   */
  TopicPublisher<DynamicMessage> messages(String topic, MessageSchema schema);

  /**
   * Whether it is known who subscribes to a topic before it is offered. Else single messages may be said wherever
   * somebody publishes, and are refused once it has turned out that nobody hears them.
   *
   * @return false where listeners show themselves only to those who publish
   */
  default boolean knowsListeners() {
    return true;
  }

  /**
   * The type of ROS by which messages of a type command a robot, where the framework has names of its own.
   *
   * @param type its name
   * @return the type of ROS that means the same, else the name itself
   */
  default String commandType(String type) {
    return type;
  }

  /**
   * How single messages are said on a topic whose messages have no definition of ROS.
   *
   * @param topic its name
   * @param type the type of its messages
   * @return says them by the names of their fields; none where such messages are not taken
   */
  default Optional<FieldsTopic> fields(String topic, String type) {
    return Optional.empty();
  }

  /**
   * Offers a topic for what other robots say, as much and as often as they do.
   *
   * @param topic its name
   * @param schema the type of its messages
   * @param kept whether the last message is given to subscribers that come later
   * @return what says them
   */
  default TopicPublisher<DynamicMessage> relayed(String topic, MessageSchema schema, boolean kept) {
    return messages(topic, schema);
  }

  /**
   * The definition of a type.
   *
   * @param type its name
   * @return the definition, or why it is not known here
   */
  SchemaLookup<MessageSchema> schema(String type);

  /**
   * Why messages of a topic to which we subscribe do not come.
   *
   * @param topic its name
   * @return a sentence, or none where nothing is known to be wrong
   */
  Optional<String> failure(String topic);

  /**
   * What those who publish a topic promise of its delivery, such as their quality of service.
   *
   * @param topic its name
   * @return a sentence, empty where the framework knows no such thing
   */
  default String delivery(String topic) {
    return "";
  }

  /**
   * Asks a server of interactive markers for all that it has, where the framework gives them by a service. Elsewhere
   * they are published on a topic beside the updates.
   *
   * @param server its name, to which {@code /update} and the like are appended
   * @param answer hears the answer on a thread of the framework, or nothing where none comes: ask again then
   * @return whether servers are asked
   */
  default boolean requestMarkers(String server, Consumer<GetInteractiveMarkersResponse> answer) {
    return false;
  }

  /**
   * Whether time is simulated: the robot then says what time it is.
   *
   * @return true while it does
   */
  boolean isSimulated();

  /**
   * The robot's time.
   *
   * @return nanoseconds since the epoch of its clock
   */
  long nowNanos();

  /**
   * What we are called.
   *
   * @return the name by which the robot knows this client
   */
  String name();
}
