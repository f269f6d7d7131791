package org.robotui.rfic.rosbridge.internal.session;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robotui.api.RficContext;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Arity;
import org.robotui.api.port.Demand;
import org.robotui.api.port.Offer;
import org.robotui.api.port.Publication;
import org.robotui.api.port.StreamPort;
import org.robotui.api.session.LinkChanges;
import org.robotui.api.session.RobotSession;
import org.robotui.api.session.SessionScope;
import org.robotui.data.status.LogEntry;
import org.robotui.message.payload.RosDefinitions;
import org.robotui.message.topic.DescriptionTopics;
import org.robotui.message.topic.RobotTopics;
import org.robotui.message.topic.ServedServices;
import org.robotui.message.topic.ServerNotices;
import org.robotui.message.topic.SharedTransforms;
import org.robotui.message.topic.TopicPorts;
import org.robotui.rfic.rosbridge.internal.RosbridgeSettings;
import org.robotui.rfic.rosbridge.internal.call.BridgeBrowser;
import org.robotui.rfic.rosbridge.internal.call.BridgeHosting;
import org.robotui.rfic.rosbridge.internal.call.BridgeParameters;
import org.robotui.rfic.rosbridge.internal.call.BridgeServices;
import org.robotui.rosbridge.RosApi;
import org.robotui.rosbridge.RosbridgeClient;
import org.robotui.web.LinkTurns;

/** One connection to a bridge, and all that is offered through it. */
public final class RosbridgeSession implements RobotSession {
  private static final Duration ANSWER = Duration.ofSeconds(3);
  private static final Duration GIVEN_UP = Duration.ofSeconds(10);
  private static final long ALIVE_NANOS = Duration.ofMillis(200).toNanos();
  private static final StreamPort<LogEntry> STATUS = new StreamPort<>("bridge_status", LogEntry.class, Arity.MANY,
      "What the bridge tells its users.");

  private final String server;
  private final RosbridgeClient client;
  private final ServerNotices notices;
  private final LinkChanges link;
  private final RosApiWatch watch;
  private final BridgeTopics channels;
  private final RobotTopics topics;
  private final DescriptionTopics description;
  private final ServedServices served;
  private final Publication<LogEntry> status;
  private final List<Offer> offers;
  private RosGraph seen = RosGraph.EMPTY;

  private RosbridgeSession(RficContext context, RosbridgeSettings settings, RosbridgeClient client,
      ServerNotices notices) {
    this.server = settings.url().toString();
    this.client = client;
    this.notices = notices;
    this.link = new LinkChanges(context.link());
    RosDefinitions definitions = new RosDefinitions(System.getenv());
    RosApi api = new RosApi(client, ANSWER);
    BridgeDefinitions types = new BridgeDefinitions(api, definitions);
    this.watch = new RosApiWatch(api, types, context.threads());
    this.channels = new BridgeTopics(client, watch, definitions, settings);
    this.topics = new RobotTopics(context, settings.topics(), channels,
        new SharedTransforms(name -> watch.graph().types().keySet().stream()
            .anyMatch(topic -> topic.startsWith("/" + name + "/"))));
    this.description = new DescriptionTopics(context, settings.topics(),
        DescriptionTopics.packages(System.getenv()), channels);
    this.served = new ServedServices(new BridgeHosting(client, api, types, channels), settings.topics());
    this.status = context.offers().stream(STATUS, Demand.IGNORED);
    this.offers = List.of(status,
        context.offers().call(TopicPorts.SERVICES, new BridgeServices(client, api, types, channels)),
        context.offers().call(TopicPorts.SERVE, served),
        context.offers().browse(TopicPorts.GRAPH,
            new BridgeBrowser(api, types, watch, new BridgeParameters(client, api, watch))));
  }

  /**
   * Connects.
   *
   * @param context what core gives
   * @param settings how the bridge is reached
   * @param scope keeps the connection until the session has been closed
   * @return the session
   * @throws IOException where there is no such bridge
   */
  public static RobotSession open(RficContext context, RosbridgeSettings settings, SessionScope scope)
      throws IOException {
    ServerNotices notices = new ServerNotices(settings.url().toString());
    try {
      RosbridgeClient client =
          scope.closing(RosbridgeClient.open(settings.url(), context.threads(), new BridgeNotices(notices)),
              RosbridgeClient::close);
      return new RosbridgeSession(context, settings, client, notices);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException("was closed while connecting", e);
    }
  }

  @Override
  public Optional<String> follow(BooleanSupplier over) throws InterruptedException {
    return LinkTurns.take(client.link().whenEnded(), over, this::turn);
  }

  /** Looks at all once; answers why the session is over, if it is. */
  private Optional<String> turn() {
    if (client.link().silentNanos() > GIVEN_UP.toNanos()) {
      return Optional.of(server + " is connected but says nothing");
    }
    client.link().beat();
    if (client.link().silentNanos() < ALIVE_NANOS) {
      topics.pulse().heard(System.nanoTime());
    }
    if (watch.graph() != seen) {
      seen = watch.graph();
      topics.follow(description.follow(seen.topics()));
    }
    channels.tick();
    topics.tick();
    served.tick();
    description.tick();
    notices.take(entry -> status.publish(entry, Optional.empty()));
    String problem = Stream.of(client.link().trouble(), watch.problem().orElse(""), topics.problem())
        .filter(part -> !part.isEmpty()).collect(Collectors.joining("; "));
    if (watch.answered() || !problem.isEmpty()) {
      link.report(problem.isEmpty() ? new LinkState.Connected(server) : new LinkState.Degraded(server, problem));
    }
    return Optional.empty();
  }

  @Override
  public void close() {
    topics.stop();
    watch.close();
    offers.forEach(Offer::close);
    served.close();
    description.close();
    topics.close();
  }
}
