package org.robotui.rfic.ros.internal;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.Descriptor;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.RficType;
import org.robotui.api.config.Settings;
import org.robotui.guard.Guards;
import org.robotui.message.topic.TopicPorts;
import org.robotui.rfic.ros.internal.graph.SharedMasters;

/** The type {@code ros}: a client of ROS 1. */
@Component(service = RficType.class)
public final class RosRficType implements RficType {
  /** Streams and commands are those that the robot has; only calling and browsing are always there. */
  private static final Descriptor DESCRIPTOR = new Descriptor("ros", "ROS 1",
      "Topics, services, parameters and transforms of a ROS 1 robot, found by asking its master.",
      RosSettings.SCHEMA, List.of(TopicPorts.SERVICES, TopicPorts.GRAPH));

  private final SharedMasters masters = new SharedMasters();
  private final Guards guards = new Guards();

  @Override
  public Descriptor descriptor() {
    return DESCRIPTOR;
  }

  @Override
  public Rfic create(RficContext context, Settings settings) {
    return new RosRfic(context, RosSettings.of(settings, System.getenv()), masters, guards);
  }
}
