package org.robotui.rfic.roboframe.internal.session;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import org.robotui.api.RficContext;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Offer;
import org.robotui.api.session.LinkChanges;
import org.robotui.api.session.RobotSession;
import org.robotui.api.session.SessionScope;
import org.robotui.message.payload.PayloadFormats;
import org.robotui.message.payload.RosDefinitions;
import org.robotui.message.topic.RobotTopics;
import org.robotui.message.topic.SharedTopics;
import org.robotui.message.topic.TopicPorts;
import org.robotui.rfic.roboframe.internal.RoboframeSettings;
import org.robotui.roboframe.link.BrokerLink;
import org.robotui.roboframe.link.BrokerOptions;
import org.robotui.roboframe.wire.BoardKey;

/** One connection to an application, and all that is offered through it. */
public final class RoboframeSession implements RobotSession {
  private static final long LOOK_MILLIS = 20;
  private static final long ALIVE_NANOS = Duration.ofMillis(250).toNanos();
  private static final long GIVEN_UP_NANOS = Duration.ofSeconds(10).toNanos();
  /** Shorter than the two seconds in which a robot interface has to end: connecting cannot be interrupted. */
  private static final Duration ANSWER = Duration.ofMillis(1500);

  private final String peer;
  private final BrokerLink link;
  private final BoardNews news;
  private final SharedTopics.Group shared;
  private final LinkChanges state;
  private final RoboframeTopics keys;
  private final RobotTopics topics;
  private final Offer graph;
  private boolean met;

  private RoboframeSession(RficContext context, RoboframeSettings settings, SharedTopics.Group shared, BrokerLink link,
      BoardNews news) {
    this.peer = settings.application().toString();
    this.link = link;
    this.news = news;
    this.shared = shared;
    this.state = new LinkChanges(context.link());
    this.keys = new RoboframeTopics(link, new PayloadFormats(new RosDefinitions(System.getenv())));
    news.tell(keys);
    this.topics = new RobotTopics(context, settings.topics(), keys, shared.transforms());
    this.graph = context.offers().browse(TopicPorts.GRAPH, new BoardBrowser(link, keys));
  }

  /**
   * Connects.
   *
   * @param context what core gives
   * @param settings how the application is reached
   * @param shared what interfaces share that speak to it
   * @param scope keeps the connection until the session has been closed
   * @return the session
   * @throws IOException where there is no such application
   */
  public static RobotSession open(RficContext context, RoboframeSettings settings, SharedTopics.Group shared,
      SessionScope scope) throws IOException {
    BoardNews news = new BoardNews();
    try {
      BrokerLink link = scope.closing(BrokerLink.connect(settings.application(),
          new BrokerOptions(RoboframeTopics.NAME, context.threads(), ANSWER, true), news), BrokerLink::close);
      return new RoboframeSession(context, settings, shared, link, news);
    } catch (IOException e) {
      throw new IOException(e.getMessage() + "; start the application, or correct host, port or ROBOFRAME_ADDR", e);
    }
  }

  @Override
  public Optional<String> follow(BooleanSupplier over) throws InterruptedException {
    while (!over.getAsBoolean()) {
      Optional<String> end = turn();
      if (end.isPresent()) {
        return end;
      }
      Thread.sleep(LOOK_MILLIS);
    }
    return Optional.empty();
  }

  /** Looks at all once; answers why the session is over, if it is. */
  private Optional<String> turn() {
    link.beat();
    long silent = link.silentNanos();
    if (silent > GIVEN_UP_NANOS) {
      return Optional.of(peer + " is connected but says nothing");
    }
    if (silent < ALIVE_NANOS) {
      topics.pulse().heard(System.nanoTime());
    }
    Optional<List<BoardKey>> said = news.take();
    if (said.isPresent()) {
      keys.follow(said.get());
      met = true;
      shared.seen(keys.board().keys().keySet());
      topics.follow(keys.board().graph());
    }
    topics.tick();
    if (met) {
      state.report(state());
    }
    return link.over();
  }

  private LinkState state() {
    String problem = topics.problem();
    return problem.isEmpty() ? new LinkState.Connected(peer) : new LinkState.Degraded(peer, problem);
  }

  @Override
  public void close() {
    topics.stop();
    graph.close();
    topics.close();
  }
}
