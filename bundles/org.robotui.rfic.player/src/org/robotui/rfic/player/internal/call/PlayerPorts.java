package org.robotui.rfic.player.internal.call;

import org.robotui.api.port.Arity;
import org.robotui.api.port.BrowsePort;
import org.robotui.api.port.CallPort;
import org.robotui.api.port.ServiceReply;
import org.robotui.api.port.ServiceRequest;

/** The ports that every Player server has, whatever its devices are. */
public final class PlayerPorts {
  /** Asks and tells devices. Guarded, since most requests change what the robot does. */
  public static final CallPort<ServiceRequest, ServiceReply> SERVICES = new CallPort<>("services", ServiceRequest.class,
      ServiceReply.class,
      Arity.MANY, "Requests to devices, and commands that do not drive, by their names such as gripper:0/open.", true);

  /** Browses the server. */
  public static final BrowsePort GRAPH =
      new BrowsePort("graph", Arity.MANY, "Devices, their messages and requests, and their drivers.");

  private PlayerPorts() {}
}
