package org.robotui.rfic.ros.internal.graph;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.robotui.api.RficContext;
import org.robotui.message.topic.DescriptionPort;
import org.robotui.message.topic.TopicSettings;
import org.robotui.ros.Parameters;
import org.robotui.ros.XmlRpcValue;

/**
 * What the robot is made of, by its parameters {@code robot_description} and {@code robot_description_semantic}: the
 * master says when they change. A robot without them offers nothing. The subscriptions of the parameters end with the
 * node.
 */
final class DescriptionFeed {
  private DescriptionFeed() {}

  /** Follows the parameters. */
  static DescriptionPort open(RficContext context, Parameters parameters, TopicSettings settings, String packagePath) {
    List<String> roots = Stream.of(packagePath.split(":")).filter(folder -> folder.startsWith("/")).toList();
    DescriptionPort port = new DescriptionPort(context, settings, "the parameter", roots);
    parameters.subscribe(port.source(), (key, value) -> port.model(text(value)));
    parameters.subscribe(port.source() + DescriptionPort.SEMANTIC, (key, value) -> port.semantics(text(value)));
    return port;
  }

  private static String text(Optional<XmlRpcValue> value) {
    return value.filter(XmlRpcValue.Text.class::isInstance).map(v -> ((XmlRpcValue.Text) v).value()).orElse("");
  }
}
