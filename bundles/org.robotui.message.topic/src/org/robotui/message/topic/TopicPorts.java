package org.robotui.message.topic;

import org.robotui.api.port.ActionOffer;
import org.robotui.api.port.ActionReply;
import org.robotui.api.port.ActionRequest;
import org.robotui.api.port.Arity;
import org.robotui.api.port.BrowsePort;
import org.robotui.api.port.CallPort;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.ServiceGrant;
import org.robotui.api.port.ServiceOffer;
import org.robotui.api.port.ServiceReply;
import org.robotui.api.port.ServiceRequest;
import org.robotui.data.command.MessageCommand;
import org.robotui.data.command.RelayMessage;
import org.robotui.data.marker.MarkerFeedback;

/** The ports that every robot with topics has, whatever they are. */
public final class TopicPorts {
  /** Calls services. */
  public static final CallPort<ServiceRequest, ServiceReply> SERVICES =
      new CallPort<>("services", ServiceRequest.class, ServiceReply.class, Arity.MANY, "Calls a service by its name.");

  /** Offers services to programs of the robot. */
  public static final CallPort<ServiceOffer, ServiceGrant> SERVE =
      new CallPort<>("serve", ServiceOffer.class, ServiceGrant.class, Arity.MANY,
          "Offers a service to the programs of the robot that is answered from outside, such as by a bridge.");

  /** Sends goals to actions. */
  public static final CallPort<ActionRequest, ActionReply> ACTIONS = new CallPort<>("actions", ActionRequest.class,
      ActionReply.class, Arity.MANY, "Sends a goal to an action by its name.", true);

  /** Offers actions to programs of the robot. */
  public static final CallPort<ActionOffer, ServiceGrant> SERVE_ACTION =
      new CallPort<>("serve_action", ActionOffer.class, ServiceGrant.class, Arity.MANY,
          "Offers an action to the programs of the robot that is carried out outside, such as by a bridge.");

  /** Browses the graph. */
  public static final BrowsePort GRAPH =
      new BrowsePort("graph", Arity.MANY, "Topics, services, actions, nodes and parameters.");

  /** Says single messages. */
  public static final CommandPort<MessageCommand> PUBLISH =
      new CommandPort<>("publish", MessageCommand.class, Arity.MANY,
          "Publishes a message on a topic by its name; not on topics that move the robot.");

  /** Says what other robots say. */
  public static final CommandPort<RelayMessage> RELAY =
      new CommandPort<>("relay", RelayMessage.class, Arity.MANY,
          "Publishes on topics what bridges bring from other robots.");

  /** Handles interactive markers. */
  public static final CommandPort<MarkerFeedback> MARKER_FEEDBACK =
      new CommandPort<>("marker_feedback", MarkerFeedback.class,
          Arity.MANY, "Tells servers of interactive markers what a user does with them.");

  private TopicPorts() {}
}
