package org.robotui.message.topic.internal;

import org.robotui.api.RficContext;
import org.robotui.api.link.Pulse;
import org.robotui.message.topic.TopicClient;
import org.robotui.message.topic.TopicSettings;

/**
 * What all ports of one session share.
 *
 * @param context what core gives
 * @param settings which topics become ports
 * @param client the framework's topics
 * @param clock the robot's time
 * @param pulse when the robot was heard last
 */
public record TopicScope(RficContext context, TopicSettings settings, TopicClient client, SessionClock clock,
    Pulse pulse) {
  /**
   * Creates a scope.
   *
   * @param context what core gives
   * @param settings which topics become ports
   * @param client the framework's topics
   */
  public TopicScope(RficContext context, TopicSettings settings, TopicClient client) {
    this(context, settings, client, new SessionClock(context, client), new Pulse());
  }
}
