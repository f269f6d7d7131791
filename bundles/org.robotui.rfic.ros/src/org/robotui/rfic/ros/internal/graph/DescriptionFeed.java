package org.robotui.rfic.ros.internal.graph;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.robotui.api.RficContext;
import org.robotui.api.port.Arity;
import org.robotui.api.port.Demand;
import org.robotui.api.port.Publication;
import org.robotui.api.port.StreamPort;
import org.robotui.data.joint.RobotDescription;
import org.robotui.rfic.ros.internal.RosSettings;
import org.robotui.ros.Parameters;
import org.robotui.ros.XmlRpcValue;

/**
 * What the robot is made of, by its parameters {@code robot_description} and {@code robot_description_semantic}: the
 * master says when they change. A robot without them offers nothing. The thread that follows the graph offers and
 * publishes; others only note what came.
 */
final class DescriptionFeed implements AutoCloseable {
  static final String NAME = "robot_description";

  private final RficContext context;
  private final String topic;
  private final String port;
  private final List<String> roots;
  private volatile String urdf = "";
  private volatile String srdf = "";
  private Optional<Publication<RobotDescription>> publication = Optional.empty();
  private Optional<RobotDescription> told = Optional.empty();
  private boolean closed;

  DescriptionFeed(RficContext context, Parameters parameters, RosSettings settings, String packagePath) {
    this.context = context;
    this.topic = settings.topics().topic(NAME);
    this.port = settings.topics().portName(topic);
    this.roots = Stream.of(packagePath.split(":")).filter(folder -> folder.startsWith("/")).toList();
    parameters.subscribe(topic, (key, value) -> urdf = text(value));
    parameters.subscribe(topic + "_semantic", (key, value) -> srdf = text(value));
  }

  /** Offers and publishes what came since. */
  synchronized void tick() {
    Optional<RobotDescription> now = now();
    if (closed || now.equals(told)) {
      return;
    }
    told = now;
    if (now.isEmpty()) {
      withdraw();
      return;
    }
    if (publication.isEmpty()) {
      publication = Optional.of(context.offers().stream(
          new StreamPort<>(port, RobotDescription.class, Arity.MANY, "the parameter " + topic), Demand.IGNORED));
    }
    publication.get().publish(now.get(), Optional.empty());
  }

  private Optional<RobotDescription> now() {
    String model = urdf;
    return model.isEmpty() ? Optional.empty()
        : Optional.of(new RobotDescription(context.robot(), topic, model, srdf, roots));
  }

  private static String text(Optional<XmlRpcValue> value) {
    return value.filter(XmlRpcValue.Text.class::isInstance).map(v -> ((XmlRpcValue.Text) v).value())
        .filter(t -> !t.isBlank() && t.length() <= RobotDescription.LONGEST).orElse("");
  }

  private void withdraw() {
    publication.ifPresent(Publication::close);
    publication = Optional.empty();
  }

  /** Withdraws the offer; the subscriptions of the parameters end with the node. */
  @Override
  public synchronized void close() {
    closed = true;
    withdraw();
  }
}
