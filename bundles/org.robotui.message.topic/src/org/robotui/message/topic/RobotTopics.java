package org.robotui.message.topic;

import org.robotui.api.RficContext;
import org.robotui.api.link.Pulse;
import org.robotui.api.port.Offer;
import org.robotui.message.topic.internal.MarkerFeedbacks;
import org.robotui.message.topic.internal.MessageTopics;
import org.robotui.message.topic.internal.RelayTopics;
import org.robotui.message.topic.internal.TopicOffers;
import org.robotui.message.topic.internal.TopicScope;
import org.robotui.message.topic.internal.TransformFeed;

/**
 * The topics of a robot as its ports, during one session: streams of what is published, commands to what is subscribed,
 * single messages, transforms, interactive markers, and the robot's time. The robot is only asked for what somebody
 * wants. For the one thread that follows the graph; {@link #stop} and {@link #close} may be called by any.
 */
public final class RobotTopics implements AutoCloseable {
  private final TopicScope scope;
  private final TopicOffers offers;
  private final TransformFeed transforms;
  private final MessageTopics messages;
  private final RelayTopics relays;
  private final Offer publish;
  private final Offer relay;
  private final Offer handled;

  /**
   * Offers what every robot with topics has; all else begins with {@link #follow}.
   *
   * @param context what core gives
   * @param settings which topics become ports
   * @param client the framework's topics; closed after this
   * @param transforms what interfaces share that see the same topics
   */
  public RobotTopics(RficContext context, TopicSettings settings, TopicClient client, SharedTransforms transforms) {
    this.scope = new TopicScope(context, settings, client);
    MarkerFeedbacks feedbacks = new MarkerFeedbacks(client, scope.pulse());
    this.offers = new TopicOffers(scope, feedbacks);
    this.handled = context.offers().command(TopicPorts.MARKER_FEEDBACK, feedbacks);
    this.transforms = new TransformFeed(scope, transforms);
    this.messages = new MessageTopics(client);
    this.publish = context.offers().command(TopicPorts.PUBLISH, messages);
    this.relays = new RelayTopics(scope);
    this.relay = context.offers().command(TopicPorts.RELAY, relays);
  }

  /**
   * When the robot was heard last: commands are refused while it is silent.
   *
   * @return is told by the framework's session when the robot answered
   */
  public Pulse pulse() {
    return scope.pulse();
  }

  /**
   * Offers what there is now.
   *
   * @param graph who publishes and subscribes what
   */
  public void follow(TopicGraph graph) {
    offers.follow(graph);
    messages.follow(graph);
    relays.follow(graph);
    transforms.follow(graph);
  }

  /** Acts on what is wanted now. To be called about twenty times a second. */
  public void tick() {
    offers.applyDemand();
    messages.tick();
    relays.tick();
    scope.clock().tick();
    transforms.tick();
  }

  /**
   * What is wanted but does not come.
   *
   * @return a sentence, empty where all is well
   */
  public String problem() {
    return offers.problem();
  }

  /**
   * Whether messages can come of anything that is wanted.
   *
   * @return true where a publisher is connected
   */
  public boolean flowing() {
    return offers.flowing();
  }

  /** Stops what we drive, and offers no commands any more. Blocks until that is sent, at most 0.3 s a topic. */
  public void stop() {
    offers.stop();
  }

  /** Stops, if that was not done, and offers nothing any more. */
  @Override
  public void close() {
    stop();
    publish.close();
    relay.close();
    handled.close();
    messages.close();
    relays.close();
    offers.close();
    transforms.close();
  }
}
