package org.robotui.rfic.roblets.internal.call;

import org.robotui.api.port.Arity;
import org.robotui.api.port.BrowsePort;
import org.robotui.api.port.CallPort;
import org.robotui.api.port.ServiceReply;
import org.robotui.api.port.ServiceRequest;
import org.robotui.api.port.StreamPort;
import org.robotui.data.status.BodyState;

/** The ports that are there whatever the robot has. */
public final class RobletsPorts {
  /** The whole body. */
  public static final StreamPort<BodyState> BODY =
      new StreamPort<>("body", BodyState.class, Arity.MANY, "The bodymap: all roblets, and what they said last.");

  /** Says messages. Guarded, since some of it changes what the robot does. */
  public static final CallPort<ServiceRequest, ServiceReply> SERVICES =
      new CallPort<>("services", ServiceRequest.class, ServiceReply.class, Arity.MANY,
          "Messages that roblets take, by the names of both.", true);

  /** Browses the body. */
  public static final BrowsePort GRAPH =
      new BrowsePort("graph", Arity.MANY, "Roblets that the brain knows, what they say, and what they take.");

  private RobletsPorts() {}
}
