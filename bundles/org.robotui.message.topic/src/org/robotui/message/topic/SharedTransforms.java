package org.robotui.message.topic;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Predicate;
import org.robotui.api.port.RawMessage;
import org.robotui.message.ros.geometry_msgs.TransformStamped;
import org.robotui.message.ros.tf2_msgs.TFMessage;
import org.robotui.message.topic.internal.HeldTransforms;
import org.robotui.message.topic.internal.TransformFeed;

/**
 * Transforms that several robot interfaces hear on the same topics: one of them listens for all. Safe for all threads.
 */
public final class SharedTransforms {
  /** A transform that holds for good, and who said it. */
  private record Fixed(TransformStamped transform, String sender) {}

  private static final int MOST_FIXED = 10_000;

  private final Predicate<String> inGraph;
  private final List<TransformFeed> feeds = new CopyOnWriteArrayList<>();
  private final Set<String> namespaces = ConcurrentHashMap.newKeySet();
  private final Map<String, Fixed> fixed = new ConcurrentHashMap<>();
  private final HeldTransforms held = new HeldTransforms();
  private final AtomicReference<TransformFeed> listener = new AtomicReference<>();

  /**
   * Nobody listens yet.
   *
   * @param inGraph whether a name is that of a namespace of the robots' graph
   */
  public SharedTransforms(Predicate<String> inGraph) {
    this.inGraph = inGraph;
  }

  /**
   * Whether a name is that of a robot whose interface listens here, or of a namespace in the graph.
   *
   * @param name without slashes
   * @return true where it is
   */
  public boolean isNamespace(String name) {
    return namespaces.contains(name) || inGraph.test(name);
  }

  /**
   * Takes one more to which what is heard is given; what was said once and holds for good it is told now.
   *
   * @param feed the transforms of a robot
   */
  public void add(TransformFeed feed) {
    feeds.add(feed);
    namespaces.add(feed.namespace());
    fixed.values().forEach(f -> feed.received(new TFMessage(List.of(f.transform())), f.sender(), true,
        System.nanoTime(), Optional.empty()));
  }

  /**
   * Gives it nothing more. Where it was the one that listened, another one may.
   *
   * @param feed the transforms of a robot
   */
  public void remove(TransformFeed feed) {
    feeds.remove(feed);
    if (listener.compareAndSet(feed, null)) {
      fixed.clear(); // who listens next is told it again
      held.clear();
    }
  }

  /**
   * What the one that listens hears.
   *
   * @param message the transforms
   * @param sender who said them
   * @param forGood whether they hold for good
   * @param receiveNanos when they were received, {@link System#nanoTime()}
   * @param raw the message as it came; none where it did not come as one
   */
  public void heard(TFMessage message, String sender, boolean forGood, long receiveNanos, Optional<RawMessage> raw) {
    if (forGood) {
      raw.ifPresent(came -> held.note(message, came));
      message.transforms().stream().filter(t -> fixed.size() < MOST_FIXED || fixed.containsKey(t.childFrameId()))
          .forEach(t -> fixed.put(t.childFrameId(), new Fixed(t, sender)));
    }
    feeds.forEach(feed -> feed.received(message, sender, forGood, receiveNanos, raw));
  }

  /**
   * The messages that hold for good, as they came.
   *
   * @param concerned whether a child frame is of interest
   * @return the newest message of each sender in which one is
   */
  public List<RawMessage> held(Predicate<String> concerned) {
    return held.messages(concerned);
  }

  /**
   * Whether one is to listen for all from now on, as nobody does.
   *
   * @param feed the transforms of a robot
   * @return true where it is to
   */
  public boolean listens(TransformFeed feed) {
    return listener.compareAndSet(null, feed);
  }
}
