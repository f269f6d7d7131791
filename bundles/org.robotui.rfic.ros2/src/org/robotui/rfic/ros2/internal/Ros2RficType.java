package org.robotui.rfic.ros2.internal;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.Descriptor;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.RficType;
import org.robotui.api.config.Settings;
import org.robotui.message.topic.TopicPorts;
import org.robotui.rfic.ros2.internal.graph.SharedDomains;

/** The type {@code ros2}: a client of ROS 2. */
@Component(service = RficType.class)
public final class Ros2RficType implements RficType {
  /** Streams and commands are those that the robot has; only calling and browsing are always there. */
  private static final Descriptor DESCRIPTOR = new Descriptor("ros2", "ROS 2",
      "Topics, services, actions, parameters and transforms of a ROS 2 robot, found by discovery.",
      Ros2Settings.SCHEMA, List.of(TopicPorts.SERVICES, TopicPorts.GRAPH));

  private final SharedDomains domains = new SharedDomains();

  @Override
  public Descriptor descriptor() {
    return DESCRIPTOR;
  }

  @Override
  public Rfic create(RficContext context, Settings settings) {
    return Ros2Sessions.rfic(context, Ros2Settings.of(settings, System.getenv()), domains);
  }
}
