package org.robotui.rfic.gazebo.internal;

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
import org.robotui.rfic.gazebo.internal.session.GazeboSession;

/** The type {@code gazebo}: robots in a simulator that speaks the transport of Gazebo. */
@Component(service = RficType.class)
public final class GazeboRficType implements RficType {
  private static final Duration RETRY = Duration.ofSeconds(1);
  /** Streams and commands are those that the robot has; only calling and browsing are always there. */
  private static final Descriptor DESCRIPTOR = new Descriptor("gazebo", "Gazebo",
      "Topics, services, poses and the clock of robots in a simulator that speaks the transport of Gazebo.",
      GazeboSettings.SCHEMA, List.of(TopicPorts.SERVICES, TopicPorts.GRAPH));

  private final SharedTopics<String> partitions = new SharedTopics<>();

  @Override
  public Descriptor descriptor() {
    return DESCRIPTOR;
  }

  @Override
  public Rfic create(RficContext context, Settings settings) {
    GazeboSettings read = GazeboSettings.of(settings, System.getenv());
    return new SessionRfic(context, read.peer(), RETRY,
        scope -> GazeboSession.open(context, read, partitions.of(read.partition()), scope));
  }
}
