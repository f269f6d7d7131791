package org.robotui.rfic.rosbridge.internal;

import java.time.Duration;
import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.Descriptor;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.RficType;
import org.robotui.api.config.Settings;
import org.robotui.api.session.SessionRfic;
import org.robotui.message.topic.TopicPorts;
import org.robotui.rfic.rosbridge.internal.session.RosbridgeSession;

/** The type {@code rosbridge}: a client of a bridge to ROS 1 or ROS 2. */
@Component(service = RficType.class)
public final class RosbridgeRficType implements RficType {
  private static final Duration RETRY = Duration.ofSeconds(3);
  /** Streams and commands are those that the robot has; only calling and browsing are always there. */
  private static final Descriptor DESCRIPTOR = new Descriptor("rosbridge", "rosbridge",
      "Topics, services, parameters and transforms of a robot of ROS 1 or ROS 2 behind a rosbridge.",
      RosbridgeSettings.SCHEMA, List.of(TopicPorts.SERVICES, TopicPorts.GRAPH));

  /** Has no robot yet. */
  public RosbridgeRficType() {
    // made by the framework
  }

  @Override
  public Descriptor descriptor() {
    return DESCRIPTOR;
  }

  @Override
  public Rfic create(RficContext context, Settings settings) {
    RosbridgeSettings read = RosbridgeSettings.of(settings);
    return new SessionRfic(context, read.url().toString(), RETRY,
        scope -> RosbridgeSession.open(context, read, scope));
  }
}
