package org.robotui.rfic.rosbridge.internal.call;

import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentHashMap;
import org.robotui.api.port.CallException;
import org.robotui.api.port.Offer;
import org.robotui.message.DefinitionException;
import org.robotui.message.DynamicMessage;
import org.robotui.message.Generation;
import org.robotui.message.MessageSchema;
import org.robotui.message.SchemaLookup;
import org.robotui.message.ServiceSchema;
import org.robotui.message.payload.CommandFormat;
import org.robotui.message.payload.JsonFormat;
import org.robotui.message.topic.CallOutcomes;
import org.robotui.message.topic.ServiceHosting;
import org.robotui.message.topic.ServiceRefusals;
import org.robotui.net.call.Outcome;
import org.robotui.rfic.rosbridge.internal.session.BridgeDefinitions;
import org.robotui.rfic.rosbridge.internal.session.BridgeDefinitions.ServiceText;
import org.robotui.rfic.rosbridge.internal.session.BridgeTopics;
import org.robotui.rosbridge.BridgeResponder;
import org.robotui.rosbridge.RosApi;
import org.robotui.rosbridge.RosbridgeClient;

/** Offers services to the nodes behind a bridge, by its operation {@code advertise_service}. */
public final class BridgeHosting implements ServiceHosting {
  private final RosbridgeClient client;
  private final RosApi api;
  private final BridgeDefinitions definitions;
  private final BridgeTopics topics;
  private final Set<String> own = ConcurrentHashMap.newKeySet();

  /**
   * Offers nothing yet.
   *
   * @param client offers
   * @param api knows what there is
   * @param definitions of services
   * @param topics knows how the robot writes messages
   */
  public BridgeHosting(RosbridgeClient client, RosApi api, BridgeDefinitions definitions, BridgeTopics topics) {
    this.client = client;
    this.api = api;
    this.definitions = definitions;
    this.topics = topics;
  }

  @Override
  public SchemaLookup<ServiceSchema> schema(String type) {
    Generation generation = topics.commandFormat().generation();
    try {
      ServiceText text = CallOutcomes.asked(() -> definitions.service(written(type)));
      return new SchemaLookup.Found<>(new ServiceSchema(type, "", MessageSchema.parse(type + "Request", text.request(),
          generation), MessageSchema.parse(type + "Response", text.response(), generation)));
    } catch (CallException | DefinitionException e) {
      return new SchemaLookup.Missing<>("the definition of " + type + " is not known: " + e.getMessage());
    }
  }

  private String written(String type) {
    return topics.commandFormat().generation() == Generation.ROS2 ? type.replace("/", "/srv/") : type;
  }

  /** The bridge does not say who serves what we offer. */
  @Override
  public Optional<String> provider(String service) {
    if (own.contains(service)) {
      return Optional.empty();
    }
    try {
      return CallOutcomes.asked(api::services).contains(service) ? Optional.of("a node of the robot")
          : Optional.empty();
    } catch (CallException e) {
      return Optional.empty();
    }
  }

  @Override
  public Offer open(String service, ServiceSchema schema, Host host) {
    own.add(service);
    BridgeResponder.Offered offered =
        client.serve(service, written(schema.type()), arguments -> answer(arguments, schema, host));
    return () -> {
      own.remove(service);
      offered.close();
    };
  }

  private CompletionStage<BridgeResponder.Answer> answer(Map<String, Object> arguments, ServiceSchema schema,
      Host host) {
    CommandFormat format = topics.commandFormat();
    DynamicMessage request;
    try {
      request = JsonFormat.message(schema.request(), arguments);
    } catch (IllegalArgumentException e) {
      return CompletableFuture.completedStage(
          answer(new Outcome.Refused<>("the request does not fit: " + e.getMessage()), schema, format));
    }
    return host.answer(request, "").thenApply(outcome -> answer(outcome, schema, format));
  }

  private static BridgeResponder.Answer answer(Outcome<DynamicMessage> outcome, ServiceSchema schema,
      CommandFormat format) {
    return new BridgeResponder.Answer(outcome instanceof Outcome.Done, outcome.toOptional()
        .or(() -> ServiceRefusals.of(schema, outcome.reason())).map(format::tree).orElse(Map.of()));
  }
}
