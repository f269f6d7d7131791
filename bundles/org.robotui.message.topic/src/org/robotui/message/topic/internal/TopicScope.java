package org.robotui.message.topic.internal;

import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
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
 * @param relayed topics on which we say what other robots say; any thread
 */
public record TopicScope(RficContext context, TopicSettings settings, TopicClient client, SessionClock clock,
    Pulse pulse, Set<String> relayed) {
  /**
   * Creates a scope.
   *
   * @param context what core gives
   * @param settings which topics become ports
   * @param client the framework's topics
   */
  public TopicScope(RficContext context, TopicSettings settings, TopicClient client) {
    this(context, settings, client, new SessionClock(context, client), new Pulse(),
        ConcurrentHashMap.newKeySet());
  }
}
