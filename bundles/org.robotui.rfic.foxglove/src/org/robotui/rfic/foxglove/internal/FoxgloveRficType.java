package org.robotui.rfic.foxglove.internal;

import java.net.URI;
import java.time.Duration;
import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.Descriptor;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.RficType;
import org.robotui.api.config.Settings;
import org.robotui.api.session.SessionRfic;
import org.robotui.message.topic.SharedTopics;
import org.robotui.message.topic.TopicPorts;
import org.robotui.rfic.foxglove.internal.session.FoxgloveSession;

/** The type {@code foxglove}: a client of servers that speak Foxglove's WebSocket protocol. */
@Component(service = RficType.class)
public final class FoxgloveRficType implements RficType {
  private static final Duration RETRY = Duration.ofSeconds(3);
  /** Streams and commands are those that the robot has; only calling and browsing are always there. */
  private static final Descriptor DESCRIPTOR = new Descriptor("foxglove", "Foxglove",
      "Topics, services, parameters and transforms of a robot behind a server that speaks Foxglove's WebSocket protocol.",
      FoxgloveSettings.SCHEMA, List.of(TopicPorts.SERVICES, TopicPorts.GRAPH));

  private final SharedTopics<URI> servers = new SharedTopics<>();

  @Override
  public Descriptor descriptor() {
    return DESCRIPTOR;
  }

  @Override
  public Rfic create(RficContext context, Settings settings) {
    FoxgloveSettings read = FoxgloveSettings.of(settings);
    return new SessionRfic(context, read.url().toString(), RETRY,
        scope -> FoxgloveSession.open(context, read, servers.of(read.url()), scope));
  }
}
