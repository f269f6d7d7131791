package org.robotui.rfic.ros.internal.graph;

import org.robotui.api.RficContext;
import org.robotui.api.port.Arity;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.CommandSink.Sent;
import org.robotui.api.port.Offer;
import org.robotui.data.Data;
import org.robotui.rfic.ros.internal.RosSettings;
import org.robotui.rfic.ros.internal.convert.CommandType;
import org.robotui.ros.Publisher;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.RosNode;

/**
 * A topic as a command port. It is advertised as soon as it is offered, as a first command would else be lost while its
 * subscribers connect; it never latches, so that nothing is said twice.
 */
final class CommandTopic implements AutoCloseable {
  private final String topic;
  private final String type;
  private final Entry<?, ?> entry;

  CommandTopic(
      String topic,
      CommandType<?, ?> command,
      RficContext context,
      RosSettings settings,
      RosNode node,
      SessionClock clock) {
    this.topic = topic;
    this.type = command.type();
    this.entry = new Entry<>(command, context, settings.portName(topic), node, clock);
  }

  String type() {
    return type;
  }

  @Override
  public void close() {
    entry.offer.close();
    entry.publisher.close();
  }

  /** Holds the types of one command together. */
  private final class Entry<D extends Data, M> {
    private final CommandType<D, M> command;
    private final SessionClock clock;
    private final Publisher<M> publisher;
    private final Offer offer;

    Entry(CommandType<D, M> command, RficContext context, String port, RosNode node, SessionClock clock) {
      this.command = command;
      this.clock = clock;
      this.publisher = node.publisher(topic, command.codec(), PublisherOptions.standard().withQueue(1));
      this.offer = context.offers().command(
          new CommandPort<>(port, command.data(), Arity.MANY, topic + ": " + command.help()), this::send);
    }

    private Sent send(D value) {
      if (publisher.numSubscribers() == 0) {
        return new Sent.Refused("nobody listens on " + topic + " now");
      }
      publisher.publish(command.message().of(value, clock.nowNanos()));
      return new Sent.Out();
    }
  }
}
