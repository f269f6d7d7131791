package org.robotui.ros2.internal.type;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import org.robotui.message.DynamicCodec;
import org.robotui.message.DynamicMessage;
import org.robotui.message.MessageException;
import org.robotui.message.RosValue;
import org.robotui.message.SchemaLookup;
import org.robotui.message.ServiceSchema;
import org.robotui.message.description.TypeHash;
import org.robotui.message.description.TypeName;
import org.robotui.message.description.TypeRegistry;
import org.robotui.net.call.Outcome;
import org.robotui.net.log.PeerText;
import org.robotui.ros2.QosProfiles;
import org.robotui.ros2.Ros2ServiceCodec;
import org.robotui.ros2.graph.GraphEnd;
import org.robotui.ros2.internal.ShippedTypes;
import org.robotui.ros2.internal.link.ClientLink;
import org.robotui.ros2.internal.link.Ends;
import org.robotui.ros2.internal.link.Waiting;
import org.robotui.ros2.name.Ros2Name;

/** Asks nodes to describe the types that they announce. */
final class DescriptionClient {

  static final TypeName SERVICE =
      new TypeName("type_description_interfaces", TypeName.Kind.SRV, "GetTypeDescription");
  private static final int MOST_NODES = 3;
  /** Which part of the time is left for asking, when it took long to learn whom. */
  private static final int ASKING = 4;

  private final Ends ends;
  private final TypeRegistry registry;
  private final ServiceSchema schema = ShippedTypes.service(SERVICE);
  private final Ros2ServiceCodec<DynamicMessage, DynamicMessage> codec = Ros2ServiceCodec.of(SERVICE, schema);

  DescriptionClient(Ends ends, TypeRegistry registry) {
    this.ends = ends;
    this.registry = registry;
  }

  /** Asks those that announce the type until one describes it; answers why none did, empty if one did. */
  Optional<String> ask(TypeName type, TypeHash hash, Supplier<List<GraphEnd>> announcers, Duration patience) {
    // processes say what they have before they say which of their nodes has it
    if (!Waiting.until(patience.minus(patience.dividedBy(ASKING)), () -> false,
        () -> !nodes(hash, announcers.get()).isEmpty())) {
      return Optional.of("no node is known by name that could describe it");
    }
    List<Ros2Name> nodes = nodes(hash, announcers.get());
    String reason = "";
    for (Ros2Name node : nodes) {
      Optional<String> refusal = ask(node, type, hash, patience.dividedBy((long) ASKING * nodes.size()));
      if (refusal.isEmpty()) {
        return refusal;
      }
      reason = refusal.get();
    }
    return Optional.of(reason);
  }

  private static List<Ros2Name> nodes(TypeHash hash, List<GraphEnd> announcers) {
    return announcers.stream().filter(end -> end.hash().filter(hash::equals).isPresent())
        .flatMap(end -> end.node().stream()).distinct().limit(MOST_NODES).toList();
  }

  private Optional<String> ask(Ros2Name node, TypeName type, TypeHash hash, Duration patience) {
    Ros2Name service = node.join("get_type_description");
    try (ClientLink<DynamicMessage, DynamicMessage> client =
        new ClientLink<>(ends, service, codec, QosProfiles.SERVICES)) {
      DynamicMessage request = new DynamicCodec(schema.request()).build(
          Map.of("type_name", type.toString(), "type_hash", hash.text(), "include_type_sources", true));
      return switch (client.call(request, patience)) {
        case Outcome.Done<DynamicMessage> done -> learn(node, type, hash, done.value());
        case Outcome<DynamicMessage> failed -> Optional.of(node + " did not describe it: " + failed.reason());
      };
    } catch (MessageException e) {
      return Optional.of(node + " describes it wrongly: " + PeerText.brief(String.valueOf(e.getMessage())));
    }
  }

  private Optional<String> learn(Ros2Name node, TypeName type, TypeHash hash, DynamicMessage answer)
      throws MessageException {
    if (answer.field("successful").filter(new RosValue.Flag(true)::equals).isEmpty()) {
      return Optional.of(node + " does not describe it: " + PeerText.brief(answer.text("failure_reason").orElse("")));
    }
    return registry.learn(type, hash, DescribedTypes.read(answer)) instanceof SchemaLookup.Missing<TypeHash> missing
        ? Optional.of(node + ": " + missing.reason())
        : Optional.empty();
  }
}
