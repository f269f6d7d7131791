package org.robotui.rfic.gazebo.internal.session;

import java.nio.ByteBuffer;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.robotui.gazebo.GazeboNode;
import org.robotui.message.data.GazeboPoses;
import org.robotui.message.payload.PayloadFormat;
import org.robotui.message.ros.tf2_msgs.TFMessage;
import org.robotui.message.topic.Arrival;
import org.robotui.message.topic.TopicListener;
import org.robotui.message.topic.TopicSubscription;
import org.robotui.rfic.gazebo.internal.scene.KnownScene;
import org.robotui.web.ArrivalSubscription;

/** Transforms: poses of all topics that say where things are, or, of what is fixed, what a scene says. */
final class PoseReception implements TopicSubscription {
  private static final int MOST = 100;
  private static final String SCENE = "scene/info";

  private final Parts parts;
  private final TopicListener<TFMessage> listener;
  private final boolean fixed;
  private final Consumer<PoseReception> end;
  private final Map<String, ArrivalSubscription> subscriptions = new HashMap<>();
  private long seen = -1;

  /**
   * Where poses come from.
   *
   * @param node receives
   * @param formats reads
   * @param scene knows frames
   */
  record Parts(GazeboNode node, TypeFormats formats, KnownScene scene) {}

  PoseReception(Parts parts, TopicListener<TFMessage> listener, boolean fixed, Consumer<PoseReception> end) {
    this.parts = parts;
    this.listener = listener;
    this.fixed = fixed;
    this.end = end;
  }

  /** Receives what is published now. */
  synchronized void follow(WorldTable table) {
    Map<String, String> now = fixed ? Map.of() : table.poses();
    List.copyOf(subscriptions.keySet()).stream().filter(each -> !now.containsKey(each))
        .forEach(each -> subscriptions.remove(each).close());
    now.forEach((topic, type) -> subscriptions.computeIfAbsent(topic, name -> subscribe(name, type)));
  }

  private ArrivalSubscription subscribe(String topic, String type) {
    PayloadFormat format = parts.formats().of(type);
    return parts.node().subscribe(topic, type, MOST, (sender, payload, nanos) -> received(format,
        payload, GazeboReception.arrival(topic, format, sender, payload, nanos)));
  }

  private void received(PayloadFormat format, ByteBuffer payload, Arrival arrival) {
    TFMessage message;
    try {
      message = GazeboPoses.message(format.read(payload), parts.scene()::frames);
    } catch (IllegalArgumentException e) {
      listener.unreadable(String.valueOf(e.getMessage()), arrival);
      return;
    }
    if (!message.transforms().isEmpty()) {
      listener.received(message, arrival);
    }
  }

  /** Says what a scene says of poses, when it has changed. */
  synchronized void tick() {
    if (parts.scene().changes() != seen) {
      seen = parts.scene().changes();
      TFMessage message = new TFMessage(parts.scene().transforms(fixed));
      if (!message.transforms().isEmpty()) {
        listener.received(message, new Arrival(SCENE, System.nanoTime(), false, "protobuf",
            ByteBuffer.allocate(0), bytes -> Optional.empty()));
      }
    }
  }

  @Override
  public synchronized int publishers() {
    return subscriptions.size();
  }

  @Override
  public Lost lost() {
    return Lost.NONE;
  }

  @Override
  public void close() {
    synchronized (this) {
      subscriptions.values().forEach(ArrivalSubscription::close);
      subscriptions.clear();
    }
    end.accept(this);
  }
}
