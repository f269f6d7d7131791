package org.robotui.rfic.ros2.internal.call;

import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.robotui.message.topic.DescriptionPort;
import org.robotui.message.topic.DescriptionTopics;
import org.robotui.message.topic.TopicSettings;
import org.robotui.ros2.Ros2Node;
import org.robotui.ros2.name.Ros2Name;

/**
 * What the robot is made of, by the parameters of its nodes, as long as no topic says it. For the thread that follows
 * the graph, but for closing.
 */
public final class DescriptionParameters implements AutoCloseable {
  private static final int MOST_WAITING = 2;
  private static final int IDLE_SECONDS = 5;

  private final NodeParameters parameters;
  private final TopicSettings settings;
  private final DescriptionTopics topics;
  private final ExecutorService worker;
  private final DescriptionParameter model;
  private final DescriptionParameter semantics;

  /**
   * Has asked nobody yet.
   *
   * @param node asks
   * @param parameters knows who has parameters
   * @param settings which namespace is the robot's
   * @param topics takes what is found
   * @param threads makes the thread that asks, which lives while there is somebody to ask
   */
  public DescriptionParameters(Ros2Node node, NodeParameters parameters, TopicSettings settings,
      DescriptionTopics topics, ThreadFactory threads) {
    this.parameters = parameters;
    this.settings = settings;
    this.topics = topics;
    ThreadPoolExecutor one = new ThreadPoolExecutor(1, 1, IDLE_SECONDS, TimeUnit.SECONDS,
        new LinkedBlockingQueue<>(MOST_WAITING), threads);
    one.allowCoreThreadTimeOut(true);
    this.worker = one;
    this.model = sought(node, DescriptionPort.NAME, named("robot_state_publisher", "controller_manager"), true);
    this.semantics = sought(node, DescriptionPort.NAME + DescriptionPort.SEMANTIC, named("move_group"), false);
  }

  private static Predicate<Ros2Name> named(String... parts) {
    return name -> Stream.of(parts).anyMatch(name.base()::contains);
  }

  private DescriptionParameter sought(Ros2Node node, String name, Predicate<Ros2Name> likely, boolean others) {
    String topic = settings.topic(name);
    return new DescriptionParameter(node, name, likely, others, worker, text -> topics.elsewhere(topic, text));
  }

  /** Looks at who is there, and asks one of them if something lacks. */
  public void look() {
    List<Ros2Name> nodes =
        parameters.nodes().stream().filter(name -> name.text().startsWith(settings.namespace())).toList();
    model.look(topics.lacks(settings.topic(DescriptionPort.NAME)), nodes);
    semantics.look(topics.lacks(settings.topic(DescriptionPort.NAME + DescriptionPort.SEMANTIC)), nodes);
  }

  /** Asks nobody any more. */
  @Override
  public void close() {
    worker.shutdownNow();
  }
}
