package org.robotui.rfic.gazebo.internal.call;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CallException;
import org.robotui.gazebo.GazeboGraph;
import org.robotui.gazebo.OfferedService;
import org.robotui.gazebo.OfferedTopic;
import org.robotui.message.payload.PayloadFormat;
import org.robotui.rfic.gazebo.internal.session.GazeboTopics;
import org.robotui.rfic.gazebo.internal.session.TypeFormats;

/** What the processes of a partition have, as discovery says it. Nodes are called by their process and their own id. */
public final class GazeboBrowser implements Browser {
  private static final int SHORT = 8;

  private final GazeboTopics topics;
  private final TypeFormats formats;
  private final GazeboServices services;

  /**
   * Creates a browser.
   *
   * @param topics knows what there is
   * @param formats knows types
   * @param services knows who answers
   */
  public GazeboBrowser(GazeboTopics topics, TypeFormats formats, GazeboServices services) {
    this.topics = topics;
    this.formats = formats;
    this.services = services;
  }

  private GazeboGraph graph() {
    return topics.table().graph();
  }

  @Override
  public List<Item> list(Kind kind) {
    return switch (kind) {
      case TOPIC -> topics.table().known().entrySet().stream().map(e -> new Item(kind, e.getKey(), e.getValue()))
          .toList();
      case SERVICE -> graph().services().stream().map(each -> new Item(kind, each.name().name(), each.request()))
          .distinct().sorted((a, b) -> a.name().compareTo(b.name())).toList();
      case NODE -> nodes().distinct().sorted().map(name -> new Item(kind, name, "")).toList();
      case PARAMETER, ACTION, TUNABLE -> List.of();
    };
  }

  private Stream<String> nodes() {
    return Stream.of(graph().topics().stream().map(GazeboBrowser::node),
        graph().subscriptions().stream().map(GazeboBrowser::node),
        graph().services().stream().map(GazeboBrowser::node)).flatMap(all -> all);
  }

  private static String node(OfferedTopic topic) {
    return name(topic.process(), topic.node());
  }

  private static String node(OfferedService service) {
    return name(service.process(), service.node());
  }

  private static String name(String process, String node) {
    return process.substring(0, Math.min(SHORT, process.length())) + "/"
        + node.substring(0, Math.min(SHORT, node.length()));
  }

  @Override
  public Description describe(Item item) throws CallException {
    return switch (item.kind()) {
      case TOPIC -> topic(item);
      case SERVICE -> service(item, services.service(item.name()));
      case NODE -> new Description(item, Map.of("publishes", of(graph().topics(), item.name()), "subscribes",
          of(graph().subscriptions(), item.name())), Optional.empty(), Optional.empty(), Optional.empty());
      case PARAMETER, ACTION, TUNABLE -> throw new CallException("a simulator has no such thing as " + item.name());
    };
  }

  private static String of(List<OfferedTopic> all, String node) {
    return joined(all.stream().filter(each -> node(each).equals(node)).map(each -> each.name().name()));
  }

  private Description topic(Item item) {
    Predicate<OfferedTopic> its = each -> each.name().name().equals(item.name());
    Map<String, String> facts = new LinkedHashMap<>();
    facts.put("type", item.type());
    facts.put("publishers", joined(graph().topics().stream().filter(its).map(OfferedTopic::address)));
    facts.put("subscribers", joined(graph().subscriptions().stream().filter(its).map(GazeboBrowser::node)));
    PayloadFormat format = formats.of(item.type());
    format.obstacle().ifPresent(reason -> facts.put("definition", reason));
    return new Description(item, facts, Optional.empty(), format.shape(), Optional.empty());
  }

  private Description service(Item item, OfferedService service) {
    PayloadFormat request = formats.of(service.request());
    PayloadFormat response = formats.of(service.response());
    Map<String, String> facts = new LinkedHashMap<>();
    facts.put("request", service.request());
    facts.put("response", service.isOneWay() ? "none" : service.response());
    facts.put("address", service.address());
    Stream.of(request, response).flatMap(each -> each.obstacle().stream()).findFirst()
        .ifPresent(reason -> facts.put("definition", reason));
    return new Description(item, facts, Optional.empty(), request.shape(), response.shape());
  }

  private static String joined(Stream<String> names) {
    String all = names.distinct().sorted().collect(Collectors.joining(", "));
    return all.isEmpty() ? "none" : all;
  }

  @Override
  public Optional<Object> parameter(String name) {
    return Optional.empty();
  }

  @Override
  public void setParameter(String name, Object value) throws CallException {
    throw new CallException("a simulator has no parameters");
  }

  @Override
  public List<Tunable> tunables(Item item) throws CallException {
    throw new CallException("a simulator has no settings of programs");
  }

  @Override
  public List<Tunable> setTunables(Item item, Map<String, Object> values) throws CallException {
    return tunables(item);
  }

  @Override
  public List<Link> links() {
    return Stream.concat(graph().topics().stream().map(each -> new Link(node(each), each.name().name(), true)),
        graph().subscriptions().stream().map(each -> new Link(node(each), each.name().name(), false))).distinct()
        .toList();
  }
}
