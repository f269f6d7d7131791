package org.robotui.uic.topics.internal;

import java.util.List;
import org.robotui.api.port.Arity;
import org.robotui.api.port.BrowsePort;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.Intake;
import org.robotui.api.port.Port;
import org.robotui.api.port.StreamPort;
import org.robotui.data.Data;
import org.robotui.data.command.MessageCommand;

/** The ports of the view. */
public final class TopicsPorts {
  public static final BrowsePort GRAPH = new BrowsePort("graph", Arity.MANY, "what the robot has");

  public static final StreamPort<Data> ALL =
      new StreamPort<>("all", Data.class, Arity.MANY, "what is looked into or measured", Intake.CHOSEN);

  public static final CommandPort<MessageCommand> PUBLISH =
      new CommandPort<>("publish", MessageCommand.class, Arity.OPTIONAL, "takes the messages that the user publishes");

  private TopicsPorts() {}

  public static List<Port> all() {
    return List.of(GRAPH, ALL, PUBLISH);
  }
}
