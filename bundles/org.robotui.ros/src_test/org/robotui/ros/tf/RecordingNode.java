package org.robotui.ros.tf;

import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Proxy;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

import org.robotui.message.tf.FrameTransform;
import org.robotui.message.MessageInfo;
import org.robotui.message.ros.tf2_msgs.TFMessage;
import org.robotui.ros.JumpListener;
import org.robotui.ros.MessageListener;
import org.robotui.ros.NodeClock;
import org.robotui.ros.Publisher;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.Reception;
import org.robotui.ros.RosNode;
import org.robotui.ros.Subscriber;

/** A node without a network: the test hands messages in and sees what goes out. */
final class RecordingNode {

  private final Map<String, MessageListener<TFMessage>> listeners = new HashMap<>();
  private final Map<String, PublisherOptions> options = new HashMap<>();
  private final List<TFMessage> sent = new ArrayList<>();
  private final List<JumpListener> jumps = new ArrayList<>();

  RosNode node() {
    return fake(RosNode.class, (proxy, method, args) -> switch (method.getName()) {
      case "clock" -> clock();
      case "subscriber" -> subscribe((String) args[0], args[3]);
      case "publisher" -> publish((String) args[0], (PublisherOptions) args[2]);
      default -> throw new UnsupportedOperationException(method.getName());
    });
  }

  private NodeClock clock() {
    return fake(NodeClock.class, (proxy, method, args) -> {
      jumps.add((JumpListener) args[0]);
      return (AutoCloseable) () -> jumps.remove(args[0]);
    });
  }

  @SuppressWarnings("unchecked")
  private Subscriber subscribe(String topic, Object listener) {
    listeners.put(topic, (MessageListener<TFMessage>) listener);
    return fake(Subscriber.class, (proxy, method, args) -> method.getName().equals("close") ? unsubscribe(topic) : 1);
  }

  private Object unsubscribe(String topic) {
    listeners.remove(topic);
    return null;
  }

  private Publisher<?> publish(String topic, PublisherOptions how) {
    options.put(topic, how);
    return fake(Publisher.class, (proxy, method, args) -> {
      if (method.getName().equals("publish")) {
        sent.add((TFMessage) args[0]);
      }
      return null;
    });
  }

  private static <T> T fake(Class<T> type, InvocationHandler handler) {
    return type.cast(Proxy.newProxyInstance(type.getClassLoader(), new Class<?>[]{type}, handler));
  }

  void receive(String topic, String callerId, FrameTransform... transforms) {
    TFMessage message = new TFMessage(List.of(transforms).stream().map(FrameTransform::toMessage).toList());
    listeners.get(topic).onMessage(message, new Reception(
        callerId, 0, ByteBuffer.allocate(0), new MessageInfo("tf2_msgs/TFMessage", "*", ""), false));
  }

  void jumpBack() {
    jumps.forEach(each -> each.onJumpBack(2, 1));
  }

  boolean listensTo(String topic) {
    return listeners.containsKey(topic);
  }

  int jumpListeners() {
    return jumps.size();
  }

  List<TFMessage> sent() {
    return sent;
  }

  PublisherOptions options(String topic) {
    return options.get(topic);
  }
}
