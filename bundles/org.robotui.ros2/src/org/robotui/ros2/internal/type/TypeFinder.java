package org.robotui.ros2.internal.type;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.robotui.message.ActionSchema;
import org.robotui.message.MessageSchema;
import org.robotui.message.SchemaLookup;
import org.robotui.message.ServiceSchema;
import org.robotui.message.description.TypeDescription;
import org.robotui.message.description.TypeHash;
import org.robotui.message.description.TypeName;
import org.robotui.message.description.TypeRegistry;
import org.robotui.ros2.Ros2Types;
import org.robotui.ros2.graph.GraphAction;
import org.robotui.ros2.graph.GraphEnd;
import org.robotui.ros2.graph.GraphService;
import org.robotui.ros2.graph.GraphTopic;
import org.robotui.ros2.internal.graph.GraphKeeper;
import org.robotui.ros2.internal.link.Ends;
import org.robotui.ros2.name.Ros2Name;
import org.robotui.rtps.Participant;

/** Finds types in the registry, and by asking nodes. */
public final class TypeFinder implements Ros2Types, AutoCloseable {

  private static final Ros2Name NOBODY = Ros2Name.of("/_types");

  private final GraphKeeper graph;
  private final TypeRegistry registry;
  private final Ends ends;
  private final DescriptionClient client;

  /**
   * Knows what the registry knows.
   *
   * @param participant asks
   * @param graph knows whom to ask
   * @param registry remembers
   */
  public TypeFinder(Participant participant, GraphKeeper graph, TypeRegistry registry) {
    this.graph = graph;
    this.registry = registry;
    ends = new Ends(participant, graph, NOBODY);
    client = new DescriptionClient(ends, registry);
  }

  @Override
  public TypeRegistry registry() {
    return registry;
  }

  /** Looks in the registry, and again after a node has described the type. */
  private <S> SchemaLookup<S> find(TypeName name, Optional<TypeHash> hash, Supplier<List<GraphEnd>> announcers,
      Duration patience, Function<Optional<TypeHash>, SchemaLookup<S>> look) {
    SchemaLookup<S> known = look.apply(hash);
    if (!(known instanceof SchemaLookup.Missing<S> missing)) {
      return known;
    }
    if (hash.isEmpty()) {
      return new SchemaLookup.Missing<>(missing.reason() + ". No sum of it is announced (ROS 2 before Iron has none),"
          + " so that no node can be asked; install the package " + name.packageName()
          + " here, or name a folder that has it");
    }
    Optional<String> refusal = client.ask(name, hash.get(), announcers, patience);
    return refusal.isEmpty() ? look.apply(hash)
        : new SchemaLookup.Missing<>(missing.reason() + "; " + refusal.get() + ". Install the package "
            + name.packageName() + " here in the robot's version, or let the robot's nodes offer their type"
            + " descriptions (parameter start_type_description_service)");
  }

  @Override
  public SchemaLookup<MessageSchema> message(TypeName name, Optional<TypeHash> hash, Duration patience) {
    return find(name, hash, () -> announcers(name), patience, sum -> registry.message(name, sum));
  }

  private List<GraphEnd> announcers(TypeName name) {
    return graph.state().topics().stream().flatMap(TypeFinder::ends)
        .filter(end -> !end.own() && end.type().filter(name::equals).isPresent()).toList();
  }

  private static Stream<GraphEnd> ends(GraphTopic topic) {
    return Stream.concat(topic.publishers().stream(), topic.subscribers().stream());
  }

  @Override
  public SchemaLookup<TypedMessage> topic(Ros2Name topic, Duration patience) {
    List<GraphEnd> all = graph.state().topic(topic).stream().flatMap(TypeFinder::ends).toList();
    if (all.isEmpty()) {
      return new SchemaLookup.Missing<>("nobody has the topic " + topic);
    }
    Optional<GraphEnd> first = all.stream().filter(end -> end.type().isPresent()).findFirst();
    if (first.isEmpty()) {
      return new SchemaLookup.Missing<>(
          topic + " has the type " + all.get(0).typeText() + ", which is none of ROS 2");
    }
    TypeName name = first.get().type().orElseThrow();
    return map(message(name, first.get().hash(), patience), schema -> new TypedMessage(name, schema));
  }

  @Override
  public SchemaLookup<TypedService> service(Ros2Name service) {
    Optional<GraphService> known = graph.state().service(service);
    Optional<TypeName> type = known.flatMap(GraphService::type);
    if (type.isEmpty()) {
      return new SchemaLookup.Missing<>("nobody offers the service " + service);
    }
    TypeName name = type.get();
    return switch (registry.service(name, Optional.empty())) {
      case SchemaLookup.Missing<ServiceSchema> missing -> new SchemaLookup.Missing<>(missing.reason() + unasked(name));
      case SchemaLookup.Found<ServiceSchema> found -> checked(name.part("Request"), found.schema().request(),
          known.get().requestHash(), new TypedService(name, found.schema()));
    };
  }

  @Override
  public SchemaLookup<TypedAction> action(Ros2Name action) {
    Optional<GraphAction> known = graph.state().action(action);
    Optional<TypeName> type = known.flatMap(GraphAction::type);
    if (type.isEmpty()) {
      return new SchemaLookup.Missing<>("nobody offers the action " + action);
    }
    TypeName name = type.get();
    Optional<TypeHash> sum = known.get().servers().stream().flatMap(end -> end.hash().stream()).findFirst();
    return switch (registry.action(name, Optional.empty())) {
      case SchemaLookup.Missing<ActionSchema> missing -> new SchemaLookup.Missing<>(missing.reason() + unasked(name));
      case SchemaLookup.Found<ActionSchema> found -> checked(name.part("SendGoal").part("Request"),
          found.schema().sendGoal().request(), sum, new TypedAction(name, found.schema()));
    };
  }

  /** Services and actions are known by the sums of their requests alone, for which no node describes anything. */
  private static String unasked(TypeName name) {
    return ". Nodes describe messages only, not services and actions; install the package " + name.packageName()
        + " here, or name a folder that has it";
  }

  private static <T> SchemaLookup<T> checked(TypeName request, MessageSchema schema, Optional<TypeHash> announced,
      T type) {
    TypeHash own = TypeDescription.of(request, schema).hash();
    return announced.filter(sum -> !sum.equals(own)).isEmpty() ? new SchemaLookup.Found<>(type)
        : new SchemaLookup.Missing<>("the robot's " + request + " has the sum " + announced.get().brief()
            + ", the one known here " + own.brief() + ": the definitions differ; install the package "
            + request.packageName() + " here in the robot's version");
  }

  private static <A, B> SchemaLookup<B> map(SchemaLookup<A> lookup, Function<A, B> function) {
    return switch (lookup) {
      case SchemaLookup.Found<A> found -> new SchemaLookup.Found<>(function.apply(found.schema()));
      case SchemaLookup.Missing<A> missing -> new SchemaLookup.Missing<>(missing.reason());
    };
  }

  @Override
  public void close() {
    ends.closeAll();
  }
}
