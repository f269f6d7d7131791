package org.robotui.ros2.internal.type;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.message.DynamicCodec;
import org.robotui.message.DynamicMessage;
import org.robotui.message.MessageException;
import org.robotui.message.MessageSchema;
import org.robotui.message.SchemaLookup;
import org.robotui.message.ServiceSchema;
import org.robotui.message.description.FieldDescription;
import org.robotui.message.description.StructDescription;
import org.robotui.message.description.TypeDescription;
import org.robotui.message.description.TypeHash;
import org.robotui.message.description.TypeName;
import org.robotui.message.description.TypeRegistry;
import org.robotui.net.log.PeerText;
import org.robotui.ros2.Ros2Node;
import org.robotui.ros2.Ros2ServiceCodec;
import org.robotui.ros2.Ros2ServiceServer;
import org.robotui.ros2.internal.ShippedTypes;

/** Describes to others the messages that this process knows. */
public final class DescriptionServer {

  private static final ServiceSchema SCHEMA = ShippedTypes.service(DescriptionClient.SERVICE);

  private final TypeRegistry registry;

  private DescriptionServer(TypeRegistry registry) {
    this.registry = registry;
  }

  /**
   * Offers the service.
   *
   * @param node whose it is
   * @return closing it takes the service back
   */
  public static Ros2ServiceServer offer(Ros2Node node) {
    DescriptionServer server = new DescriptionServer(node.context().types().registry());
    return node.serviceServer("~/get_type_description", Ros2ServiceCodec.of(DescriptionClient.SERVICE, SCHEMA),
        (request, caller) -> server.answer(request));
  }

  private DynamicMessage answer(DynamicMessage request) {
    String type = request.text("type_name").orElse("");
    SchemaLookup<TypeDescription> found = find(type, request.text("type_hash").orElse(""));
    Map<String, ?> values = switch (found) {
      case SchemaLookup.Found<TypeDescription> known -> Map.of("successful", true, "type_description",
          Map.of("type_description", struct(known.schema().main()),
              "referenced_type_descriptions",
              known.schema().referenced().stream().map(DescriptionServer::struct).toList()));
      case SchemaLookup.Missing<TypeDescription> missing -> Map.of("successful", false, "failure_reason",
          missing.reason());
    };
    try {
      return new DynamicCodec(SCHEMA.response()).build(values);
    } catch (MessageException e) {
      throw new IllegalStateException("the description of " + type + " does not fit into an answer", e);
    }
  }

  private SchemaLookup<TypeDescription> find(String type, String sum) {
    Optional<TypeName> name = TypeName.parse(type);
    Optional<TypeHash> hash = TypeHash.parse(sum);
    if (name.isEmpty() || hash.isEmpty() && !sum.isEmpty()) {
      return new SchemaLookup.Missing<>(
          "'" + PeerText.brief(name.isEmpty() ? type : sum) + "' is no " + (name.isEmpty() ? "name" : "sum")
              + " of a type");
    }
    return switch (registry.message(name.get(), hash)) {
      case SchemaLookup.Found<MessageSchema> found -> new SchemaLookup.Found<>(
          TypeDescription.of(name.get(), found.schema()));
      case SchemaLookup.Missing<MessageSchema> missing -> new SchemaLookup.Missing<>(missing.reason());
    };
  }

  private static Map<String, ?> struct(StructDescription type) {
    return Map.of("type_name", type.typeName(), "fields", fields(type.fields()));
  }

  private static List<Map<String, ?>> fields(List<FieldDescription> fields) {
    return fields.stream().<Map<String, ?>>map(field -> Map.of("name", field.name(),
        "type", Map.of("type_id", field.typeId(), "capacity", field.capacity(),
            "string_capacity", field.stringCapacity(), "nested_type_name", field.nestedTypeName()),
        "default_value", field.defaultValue())).toList();
  }
}
