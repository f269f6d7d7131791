package org.robotui.message.topic.internal;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import org.robotui.api.port.RawMessage;
import org.robotui.message.ros.geometry_msgs.TransformStamped;
import org.robotui.message.ros.tf2_msgs.TFMessage;

/**
 * Messages of transforms that hold for good, the newest of each sender: it is what its robot would say again to those
 * who come later. Safe for all threads.
 */
public final class HeldTransforms {
  private static final int MOST_SENDERS = 1000;

  private record Held(List<String> children, RawMessage message) {}

  private final Map<String, Held> bySender = new LinkedHashMap<>();

  /**
   * Takes note of a message.
   *
   * @param message the transforms
   * @param raw as it came
   */
  public synchronized void note(TFMessage message, RawMessage raw) {
    String sender = raw.origin().topic() + " " + raw.origin().sender();
    if (bySender.size() < MOST_SENDERS || bySender.containsKey(sender)) {
      bySender.put(sender, new Held(message.transforms().stream().map(TransformStamped::childFrameId).toList(), raw));
    }
  }

  /**
   * What holds.
   *
   * @param concerned whether a child frame is of interest
   * @return the messages in which one is
   */
  public synchronized List<RawMessage> messages(Predicate<String> concerned) {
    return bySender.values().stream().filter(held -> held.children().stream().anyMatch(concerned)).map(Held::message)
        .toList();
  }

  /** Holds nothing more. */
  public synchronized void clear() {
    bySender.clear();
  }
}
