package org.robotui.message.description;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.robotui.message.ActionSchema;
import org.robotui.message.FieldDefinition;
import org.robotui.message.FieldType;
import org.robotui.message.MessageDefinition;
import org.robotui.message.MessageSchema;
import org.robotui.message.Primitive;
import org.robotui.message.ServiceSchema;

/** Describes types by their definitions. The built-in times count as the messages that they are in ROS 2. */
final class DescriptionMaker {

  private static final TypeName TIME = new TypeName("builtin_interfaces", TypeName.Kind.MSG, "Time");
  private static final TypeName DURATION = new TypeName("builtin_interfaces", TypeName.Kind.MSG, "Duration");
  private static final TypeName EVENT_INFO = new TypeName("service_msgs", TypeName.Kind.MSG, "ServiceEventInfo");
  private static final int GID_BYTES = 16;

  private final Map<String, StructDescription> found = new LinkedHashMap<>();
  /** Names of types that are no messages, by the plain name that this library gives them. */
  private final Map<String, TypeName> names = new LinkedHashMap<>();

  private final TypeName name;

  DescriptionMaker(TypeName name) {
    this.name = name;
    if (name.kind() == TypeName.Kind.ACTION) {
      TypeName action = name.action();
      ActionParts.MESSAGES.forEach(part -> names.put(action.part(part).plain(), action.part(part)));
    }
  }

  TypeDescription message(MessageSchema schema) {
    names.put(schema.definition().type(), name);
    add(schema);
    return result(name);
  }

  TypeDescription service(ServiceSchema schema) {
    service(name, schema);
    return result(name);
  }

  TypeDescription action(ActionSchema schema) {
    List.of(schema.goal(), schema.result(), schema.feedback(), schema.feedbackMessage()).forEach(this::add);
    service(name.part("SendGoal"), schema.sendGoal());
    service(name.part("GetResult"), schema.getResult());
    put(name, List.of(FieldDescription.nested("goal", name.part("Goal")),
        FieldDescription.nested("result", name.part("Result")),
        FieldDescription.nested("feedback", name.part("Feedback")),
        FieldDescription.nested("send_goal_service", name.part("SendGoal")),
        FieldDescription.nested("get_result_service", name.part("GetResult")),
        FieldDescription.nested("feedback_message", name.part("FeedbackMessage"))));
    return result(name);
  }

  private void service(TypeName service, ServiceSchema schema) {
    TypeName request = service.part("Request");
    TypeName response = service.part("Response");
    TypeName event = service.part("Event");
    names.put(schema.request().definition().type(), request);
    names.put(schema.response().definition().type(), response);
    add(schema.request());
    add(schema.response());
    put(event, List.of(FieldDescription.nested("info", EVENT_INFO),
        FieldDescription.nested("request", request, FieldKind.BOUNDED_SEQUENCE, 1),
        FieldDescription.nested("response", response, FieldKind.BOUNDED_SEQUENCE, 1)));
    eventInfo();
    put(service, List.of(FieldDescription.nested("request_message", request),
        FieldDescription.nested("response_message", response), FieldDescription.nested("event_message", event)));
  }

  private void eventInfo() {
    put(EVENT_INFO, List.of(plain("event_type", Primitive.UINT8, FieldKind.ONE, 0), temporal("stamp", TIME),
        plain("client_gid", Primitive.UINT8, FieldKind.ARRAY, GID_BYTES),
        plain("sequence_number", Primitive.INT64, FieldKind.ONE, 0)));
  }

  private static FieldDescription plain(String field, Primitive type, int arity, long capacity) {
    return new FieldDescription(field, FieldKind.of(type, false) + arity, capacity, 0, "", "");
  }

  private FieldDescription temporal(String field, TypeName type) {
    time(type);
    return FieldDescription.nested(field, type);
  }

  private void time(TypeName type) {
    put(type, List.of(plain("sec", Primitive.INT32, FieldKind.ONE, 0),
        plain("nanosec", Primitive.UINT32, FieldKind.ONE, 0)));
  }

  private void add(MessageSchema schema) {
    List<MessageDefinition> all = new ArrayList<>(List.of(schema.definition()));
    all.addAll(schema.nested().values());
    for (MessageDefinition each : all) {
      put(name(each.type()), each.fields().stream().map(this::field).toList());
    }
  }

  private void put(TypeName type, List<FieldDescription> fields) {
    found.putIfAbsent(type.toString(), new StructDescription(type.toString(), fields));
  }

  private TypeDescription result(TypeName main) {
    StructDescription root = found.remove(main.toString());
    Collection<StructDescription> rest = found.values();
    return new TypeDescription(root, List.copyOf(rest));
  }

  private FieldDescription field(FieldDefinition field) {
    FieldType type = field.type();
    String initial = field.initial().orElse("");
    int arity = switch (type.arity()) {
      case ONE -> FieldKind.ONE;
      case FIXED -> FieldKind.ARRAY;
      case VARIABLE -> type.bound() > 0 ? FieldKind.BOUNDED_SEQUENCE : FieldKind.SEQUENCE;
    };
    long capacity = Math.max(type.length(), type.bound());
    if (type.primitive().filter(p -> !p.isTemporal()).isPresent()) {
      int element = FieldKind.of(type.primitive().get(), type.textBound() > 0);
      return new FieldDescription(field.name(), element + arity, capacity, type.textBound(), "", initial);
    }
    TypeName nested = nestedName(type);
    return new FieldDescription(field.name(), FieldKind.NESTED + arity, capacity, 0, nested.toString(), initial);
  }

  private TypeName nestedName(FieldType type) {
    if (type.primitive().isEmpty()) {
      return name(type.base());
    }
    TypeName temporal = type.primitive().get() == Primitive.TIME ? TIME : DURATION;
    time(temporal);
    return temporal;
  }

  private TypeName name(String plain) {
    TypeName known = names.get(plain);
    return known != null ? known : typeName(plain, TypeName.Kind.MSG);
  }

  private static TypeName typeName(String plain, TypeName.Kind kind) {
    return TypeName.parse(plain, kind)
        .orElseThrow(() -> new IllegalArgumentException("'" + plain + "' is no name of a type"));
  }
}
