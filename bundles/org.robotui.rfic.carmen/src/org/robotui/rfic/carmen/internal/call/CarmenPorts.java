package org.robotui.rfic.carmen.internal.call;

import org.robotui.api.port.Arity;
import org.robotui.api.port.BrowsePort;
import org.robotui.api.port.CallPort;
import org.robotui.api.port.ServiceReply;
import org.robotui.api.port.ServiceRequest;

/** The ports that are there whatever programs run. */
public final class CarmenPorts {
  /** Asks and tells programs. Guarded, since some of it changes what the robot does. */
  public static final CallPort<ServiceRequest, ServiceReply> SERVICES =
      new CallPort<>("services", ServiceRequest.class, ServiceReply.class, Arity.MANY,
          "Questions to CARMEN's programs, and messages that do not drive, by their names.", true);

  /** Browses the central. */
  public static final BrowsePort GRAPH =
      new BrowsePort("graph", Arity.MANY, "Messages of the central, and CARMEN's parameters.");

  private CarmenPorts() {}
}
