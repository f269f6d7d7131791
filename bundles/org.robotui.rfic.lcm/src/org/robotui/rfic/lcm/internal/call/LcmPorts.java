package org.robotui.rfic.lcm.internal.call;

import org.robotui.api.port.Arity;
import org.robotui.api.port.BrowsePort;
import org.robotui.api.port.CommandPort;
import org.robotui.data.command.MessageCommand;
import org.robotui.data.command.RelayMessage;

/** The ports that are always there, whatever is heard. */
public final class LcmPorts {
  /** Browses what is heard. */
  public static final BrowsePort CHANNELS =
      new BrowsePort("channels", Arity.MANY, "Channels, their types, and who sends on them.");

  /** Says single messages. */
  public static final CommandPort<MessageCommand> PUBLISH =
      new CommandPort<>("publish", MessageCommand.class, Arity.MANY,
          "Publishes a message on a channel by its name; not on channels that move the robot.");

  /** Says what other robots say. */
  public static final CommandPort<RelayMessage> RELAY =
      new CommandPort<>("relay", RelayMessage.class, Arity.MANY,
          "Publishes on channels what bridges bring from other robots.");

  private LcmPorts() {}
}
