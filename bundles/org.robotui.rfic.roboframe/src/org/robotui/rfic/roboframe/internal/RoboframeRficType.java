package org.robotui.rfic.roboframe.internal;

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
import org.robotui.net.socket.HostPort;
import org.robotui.rfic.roboframe.internal.session.RoboframeSession;

/** The type {@code roboframe}: a client of applications of RoboFrame, by the wire of ours. */
@Component(service = RficType.class)
public final class RoboframeRficType implements RficType {
  private static final Duration RETRY = Duration.ofSeconds(2);
  /** Streams and commands are those of the application's modules; only browsing is always there. */
  private static final Descriptor DESCRIPTOR = new Descriptor("roboframe", "RoboFrame",
      "Channels of an application of RoboFrame, through the TCP connection between brokers.",
      RoboframeSettings.SCHEMA, List.of(TopicPorts.GRAPH));

  private final SharedTopics<HostPort> applications = new SharedTopics<>();

  @Override
  public Descriptor descriptor() {
    return DESCRIPTOR;
  }

  @Override
  public Rfic create(RficContext context, Settings settings) {
    return create(context, RoboframeSettings.of(settings, System.getenv()));
  }

  Rfic create(RficContext context, RoboframeSettings settings) {
    return new SessionRfic(context, settings.application().toString(), RETRY,
        scope -> RoboframeSession.open(context, settings, applications.of(settings.application()), scope));
  }
}
