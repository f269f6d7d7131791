package org.robotui.rfic.ros.internal;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.RficType;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Settings;
import org.robotui.api.port.Port;
import org.robotui.rfic.ros.internal.call.RosPorts;

/** The type {@code ros}: a client of ROS 1. */
@Component(service = RficType.class)
public final class RosRficType implements RficType {
  @Override
  public String id() {
    return "ros";
  }

  @Override
  public String label() {
    return "ROS 1";
  }

  @Override
  public String help() {
    return "Topics, services, parameters and transforms of a ROS 1 robot, found by asking its master.";
  }

  @Override
  public Schema schema() {
    return RosSettings.SCHEMA;
  }

  /** Streams and commands are those that the robot has; only calling and browsing are always there. */
  @Override
  public List<Port> ports() {
    return List.of(RosPorts.SERVICES, RosPorts.GRAPH);
  }

  @Override
  public Rfic create(RficContext context, Settings settings) {
    return new RosRfic(context, RosSettings.of(settings, System.getenv()));
  }
}
