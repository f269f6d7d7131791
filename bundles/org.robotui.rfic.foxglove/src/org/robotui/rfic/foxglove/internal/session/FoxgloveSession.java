package org.robotui.rfic.foxglove.internal.session;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Set;
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
import org.robotui.foxglove.FoxgloveClient;
import org.robotui.foxglove.ServerInfo;
import org.robotui.message.payload.PayloadFormats;
import org.robotui.message.payload.RosDefinitions;
import org.robotui.message.topic.DescriptionTopics;
import org.robotui.message.topic.RobotTopics;
import org.robotui.message.topic.SharedTopics;
import org.robotui.message.topic.TopicPorts;
import org.robotui.rfic.foxglove.internal.FoxgloveSettings;
import org.robotui.rfic.foxglove.internal.call.FoxgloveBrowser;
import org.robotui.rfic.foxglove.internal.call.FoxgloveServices;
import org.robotui.rfic.foxglove.internal.call.ServerParameters;
import org.robotui.web.LinkTurns;

/** One connection to a server, and all that is offered through it. */
public final class FoxgloveSession implements RobotSession {
  private static final Duration LOOK = Duration.ofMillis(500);
  private static final Duration INTRODUCTION = Duration.ofSeconds(5);
  private static final Duration GIVEN_UP = Duration.ofSeconds(10);
  private static final long ALIVE_NANOS = Duration.ofMillis(200).toNanos();
  private static final StreamPort<LogEntry> STATUS = new StreamPort<>("server_status", LogEntry.class, Arity.MANY,
      "What the server tells its users.");

  private final FoxgloveSettings settings;
  private final String server;
  private final FoxgloveClient client;
  private final ServerNews news;
  private final SharedTopics.Group shared;
  private final LinkChanges link;
  private final FoxgloveTopics channels;
  private final RobotTopics topics;
  private final DescriptionTopics description;
  private final ServerParameters parameters;
  private final Publication<LogEntry> status;
  private final List<Offer> offers;
  private final long opened = System.nanoTime();
  private boolean met;
  private long nextLook = opened;

  private FoxgloveSession(RficContext context, FoxgloveSettings settings, SharedTopics.Group shared,
      FoxgloveClient client, ServerNews news) {
    this.settings = settings;
    this.server = settings.url().toString();
    this.client = client;
    this.news = news;
    this.shared = shared;
    this.link = new LinkChanges(context.link());
    PayloadFormats formats = new PayloadFormats(new RosDefinitions(System.getenv()));
    this.channels = new FoxgloveTopics(client, news, formats, server);
    this.topics = new RobotTopics(context, settings.topics(), channels, shared.transforms());
    this.description = new DescriptionTopics(context, settings.topics(),
        DescriptionTopics.packages(System.getenv()), channels);
    this.parameters = new ServerParameters(client, news);
    this.status = context.offers().stream(STATUS, Demand.IGNORED);
    FoxgloveServices services = new FoxgloveServices(client, formats);
    this.offers = List.of(status, context.offers().call(TopicPorts.SERVICES, services), context.offers()
        .browse(TopicPorts.GRAPH, new FoxgloveBrowser(client, news, channels, services, parameters)));
  }

  /**
   * Connects.
   *
   * @param context what core gives
   * @param settings how the server is reached
   * @param shared what interfaces share that speak to the server
   * @param scope keeps the connection until the session has been closed
   * @return the session
   * @throws IOException where there is no such server
   */
  public static RobotSession open(RficContext context, FoxgloveSettings settings, SharedTopics.Group shared,
      SessionScope scope) throws IOException {
    ServerNews news = new ServerNews(settings.url().toString());
    try {
      FoxgloveClient client =
          scope.closing(FoxgloveClient.open(settings.url(), context.threads(), news), FoxgloveClient::close);
      return new FoxgloveSession(context, settings, shared, client, news);
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
    client.link().beat();
    long now = System.nanoTime();
    long silent = client.link().silentNanos();
    if (silent > GIVEN_UP.toNanos() || client.info().isEmpty() && now - opened > INTRODUCTION.toNanos()) {
      return Optional.of(server + " is connected but says nothing");
    }
    if (silent < ALIVE_NANOS) {
      topics.pulse().heard(now);
    }
    client.info().ifPresent(info -> look(info, now));
    topics.tick();
    description.tick();
    parameters.tick();
    news.notices().take(entry -> status.publish(entry, Optional.empty()));
    if (met) {
      link.report(state());
    }
    return Optional.empty();
  }

  private void look(ServerInfo info, long now) {
    if (!met && info.can(ServerInfo.CONNECTION_GRAPH)) {
      client.followGraph();
    }
    met = true;
    if (channels.tick() || now - nextLook >= 0) {
      nextLook = now + LOOK.toNanos();
      shared.seen(channels.table().topics());
      topics.follow(description.follow(ServerGraph.of(channels.table(), channels.subscribers(), settings.topics(),
          Set.of(settings.topics().topic(STATUS.name())))));
    }
  }

  private LinkState state() {
    String problem = Stream.of(client.link().trouble(), mute(), topics.problem()).filter(part -> !part.isEmpty())
        .collect(Collectors.joining("; "));
    return problem.isEmpty() ? new LinkState.Connected(server) : new LinkState.Degraded(server, problem);
  }

  /** Commands that were configured and cannot be given. */
  private String mute() {
    boolean wanted = settings.topics().commands().values().stream().anyMatch(names -> !names.isEmpty());
    if (!wanted || channels.commandFormat().isPresent()) {
      return "";
    }
    return client.info().filter(info -> info.can(ServerInfo.CLIENT_PUBLISH)).isPresent()
        ? "the server takes messages in none of the encodings cdr, ros1 and json, so that nothing can be commanded"
        : "the server takes no messages (it lacks clientPublish), so that nothing can be commanded";
  }

  @Override
  public void close() {
    topics.stop();
    offers.forEach(Offer::close);
    parameters.close();
    description.close();
    topics.close();
  }
}
