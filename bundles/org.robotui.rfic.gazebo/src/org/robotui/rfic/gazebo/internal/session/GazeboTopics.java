package org.robotui.rfic.gazebo.internal.session;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.robotui.gazebo.GazeboNode;
import org.robotui.gazebo.GazeboPublisher;
import org.robotui.message.DynamicMessage;
import org.robotui.message.MessageSchema;
import org.robotui.message.SchemaLookup;
import org.robotui.message.data.Adapters;
import org.robotui.message.data.MessageForm;
import org.robotui.message.ros.geometry_msgs.Twist;
import org.robotui.message.ros.geometry_msgs.Vector3;
import org.robotui.message.ros.tf2_msgs.TFMessage;
import org.robotui.message.payload.PayloadFormat;
import org.robotui.message.topic.FieldsTopic;
import org.robotui.message.topic.PromptPublisher;
import org.robotui.message.topic.TopicClient;
import org.robotui.message.topic.TopicListener;
import org.robotui.message.topic.TopicPublisher;
import org.robotui.message.topic.TopicSubscription;
import org.robotui.rfic.gazebo.internal.scene.KnownScene;

/** The topics of a partition. What there is is followed by {@link #tick}, which one thread calls. */
public final class GazeboTopics implements TopicClient {
  private static final String NAME = "robotui";
  private static final String FIXED = "/tf_static";

  private final GazeboNode node;
  private final NodeNews news;
  private final TypeFormats formats;
  private final SimulatedTime time;
  private final KnownScene scene;
  private final List<PoseReception> poses = new CopyOnWriteArrayList<>();
  private volatile WorldTable table = WorldTable.EMPTY;

  GazeboTopics(GazeboNode node, NodeNews news, TypeFormats formats, KnownScene scene) {
    this.node = node;
    this.news = news;
    this.formats = formats;
    this.scene = scene;
    this.time = new SimulatedTime(node, formats);
  }

  /** Takes note of what has changed; answers whether anything has. */
  boolean tick() {
    boolean changed = news.take();
    if (changed) {
      table = WorldTable.of(node.graph());
      time.follow(table);
      poses.forEach(each -> each.follow(table));
    }
    poses.forEach(PoseReception::tick);
    return changed;
  }

  /**
   * What there is now.
   *
   * @return by name
   */
  public WorldTable table() {
    return table;
  }

  SimulatedTime time() {
    return time;
  }

  @Override
  public boolean isDefined(String topic) {
    return false;
  }

  @Override
  @SuppressWarnings("unchecked") // the form is that of transforms
  public <M> TopicSubscription subscribe(String topic, String type, MessageForm<M> form, TopicListener<M> listener) {
    if (form instanceof MessageForm.Bound<?> bound && bound.type().equals(TFMessage.class)) {
      PoseReception made = new PoseReception(new PoseReception.Parts(node, formats, scene),
          (TopicListener<TFMessage>) listener, topic.endsWith(FIXED), poses::remove);
      poses.add(made);
      made.follow(table);
      return made;
    }
    return new GazeboReception<>(node, topic, new GazeboReception.Read<>(type, formats.of(type).reading(form),
        formats.of(type), new Adapters().mostWaiting(type, form)), listener, () -> table);
  }

  @Override
  public <M extends Record> TopicPublisher<M> commands(String topic, String type, Class<M> form, int mostWaiting) {
    if (!form.equals(Twist.class)) {
      return PromptPublisher.unheard();
    }
    String name = table.prefix() + "Twist";
    GazeboPublisher publisher = node.advertise(topic, name);
    return new PromptPublisher<>((message, patience) -> publisher.publish(written(name, (Twist) message)),
        publisher::subscribers, publisher::close);
  }

  private byte[] written(String type, Twist twist) {
    return formats.written(type, Map.of("linear", vector(twist.linear()), "angular", vector(twist.angular())));
  }

  private static Map<String, Object> vector(Vector3 v) {
    return Map.of("x", v.x(), "y", v.y(), "z", v.z());
  }

  @Override
  public TopicPublisher<DynamicMessage> messages(String topic, MessageSchema schema) {
    return PromptPublisher.unheard();
  }

  /** Nodes say what they want to those who publish it, and to nobody else where the transport is of version 11. */
  @Override
  public boolean knowsListeners() {
    return false;
  }

  @Override
  public String commandType(String type) {
    return WorldTable.commandType(type);
  }

  @Override
  public Optional<FieldsTopic> fields(String topic, String type) {
    PayloadFormat format = formats.of(type);
    return format.obstacle().isPresent() ? Optional.empty()
        : Optional.of(new FieldsTopic(format::write, () -> publishing(topic, type)));
  }

  private TopicPublisher<ByteBuffer> publishing(String topic, String type) {
    GazeboPublisher publisher = node.advertise(topic, type);
    return new PromptPublisher<>((message, patience) -> publisher.publish(TypeFormats.bytes(message)),
        publisher::subscribers, publisher::close);
  }

  @Override
  public SchemaLookup<MessageSchema> schema(String type) {
    return new SchemaLookup.Missing<>(type + " is no type of ROS");
  }

  @Override
  public Optional<String> failure(String topic) {
    return Optional.empty();
  }

  @Override
  public boolean isSimulated() {
    return time.now().isPresent();
  }

  @Override
  public long nowNanos() {
    return time.now().orElseGet(() -> System.currentTimeMillis() * 1_000_000L);
  }

  @Override
  public String name() {
    return NAME;
  }

  void close() {
    time.close();
  }
}
