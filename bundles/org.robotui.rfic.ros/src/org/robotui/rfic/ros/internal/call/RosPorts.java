package org.robotui.rfic.ros.internal.call;

import org.robotui.api.port.Arity;
import org.robotui.api.port.BrowsePort;
import org.robotui.api.port.CallPort;
import org.robotui.api.port.ServiceReply;
import org.robotui.api.port.ServiceRequest;

/** The ports that every ROS robot has. */
public final class RosPorts {
  /** Calls any service. */
  public static final CallPort<ServiceRequest, ServiceReply> SERVICES =
      new CallPort<>("services", ServiceRequest.class, ServiceReply.class, Arity.MANY, "Calls a service by its name.");

  /** Lists topics, services, nodes and parameters. */
  public static final BrowsePort GRAPH = new BrowsePort("graph", Arity.MANY, "Topics, services, nodes and parameters.");

  private RosPorts() {}
}
