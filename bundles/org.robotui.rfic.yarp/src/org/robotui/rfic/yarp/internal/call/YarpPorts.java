package org.robotui.rfic.yarp.internal.call;

import org.robotui.api.port.Arity;
import org.robotui.api.port.BrowsePort;
import org.robotui.api.port.CallPort;
import org.robotui.api.port.ServiceReply;
import org.robotui.api.port.ServiceRequest;

/** The ports that are there whatever the robot has. */
public final class YarpPorts {
  /** Asks ports. Guarded, since some of it changes what the robot does. */
  public static final CallPort<ServiceRequest, ServiceReply> SERVICES =
      new CallPort<>("services", ServiceRequest.class, ServiceReply.class, Arity.MANY,
          "Questions to the robot's ports, by their names.", true);

  /** Browses the name server. */
  public static final BrowsePort GRAPH =
      new BrowsePort("graph", Arity.MANY, "Ports that the name server knows, and whom they say their messages to.");

  private YarpPorts() {}
}
