package org.robotui.rfic.ros2.internal.call;

import java.util.Optional;
import org.robotui.api.port.Offer;
import org.robotui.message.DynamicMessage;
import org.robotui.message.SchemaLookup;
import org.robotui.message.ServiceSchema;
import org.robotui.message.description.TypeName;
import org.robotui.message.topic.ServiceHosting;
import org.robotui.message.topic.ServiceRefusals;
import org.robotui.net.call.Outcome;
import org.robotui.ros2.QosProfiles;
import org.robotui.ros2.Ros2Node;
import org.robotui.ros2.Ros2ServiceCodec;
import org.robotui.ros2.graph.GraphEnd;
import org.robotui.ros2.name.Ros2Name;

/**
 * Offers services to nodes of ROS 2, which cannot be told that a call was refused: a response that has the fields
 * {@code success} and {@code message} says it, and others do not come.
 *
 * @param node offers them
 */
public record Ros2Hosting(Ros2Node node) implements ServiceHosting {
  @Override
  public SchemaLookup<ServiceSchema> schema(String type) {
    return name(type).map(name -> node.context().types().registry().service(name, Optional.empty()))
        .orElseGet(() -> new SchemaLookup.Missing<>("'" + type + "' is no name of a type of services"));
  }

  private static Optional<TypeName> name(String type) {
    return TypeName.parse(type, TypeName.Kind.SRV);
  }

  @Override
  public Optional<String> provider(String service) {
    return Ros2Name.parse(service).flatMap(node.context().graph().state()::service).stream()
        .flatMap(known -> known.servers().stream()).filter(end -> !end.own()).map(GraphEnd::who).findFirst();
  }

  @Override
  public Offer open(String service, ServiceSchema schema, Host host) {
    TypeName type = name(schema.type())
        .orElseThrow(() -> new IllegalArgumentException("'" + schema.type() + "' is no name of a type of services"));
    return node.deferringServer(service, Ros2ServiceCodec.of(type, schema), QosProfiles.SERVICES,
        (request, caller) -> host.answer(request, caller).thenApply(outcome -> response(outcome, schema)))::close;
  }

  private static DynamicMessage response(Outcome<DynamicMessage> outcome, ServiceSchema schema) {
    return outcome.toOptional().or(() -> ServiceRefusals.of(schema, outcome.reason()))
        .orElseThrow(() -> new IllegalStateException(outcome.reason()));
  }
}
