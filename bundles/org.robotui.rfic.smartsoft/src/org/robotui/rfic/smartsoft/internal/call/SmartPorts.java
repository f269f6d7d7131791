package org.robotui.rfic.smartsoft.internal.call;

import org.robotui.api.port.Arity;
import org.robotui.api.port.BrowsePort;
import org.robotui.api.port.CallPort;
import org.robotui.api.port.ServiceReply;
import org.robotui.api.port.ServiceRequest;

/** The ports that are there whatever components run. */
public final class SmartPorts {
  /** Asks and tells components. Guarded, since some of it changes what the robot does. */
  public static final CallPort<ServiceRequest, ServiceReply> SERVICES =
      new CallPort<>("services", ServiceRequest.class, ServiceReply.class, Arity.MANY,
          "Queries, what can be sent and does not drive, and events that are waited for once, by component and service.",
          true);

  /** Browses the naming service. */
  public static final BrowsePort GRAPH =
      new BrowsePort("graph", Arity.MANY, "Components, their services, and the states in which they are.");

  private SmartPorts() {}
}
