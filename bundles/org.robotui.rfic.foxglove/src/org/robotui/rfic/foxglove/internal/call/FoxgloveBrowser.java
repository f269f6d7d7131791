package org.robotui.rfic.foxglove.internal.call;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CallException;
import org.robotui.data.record.RecordShape;
import org.robotui.foxglove.FoxgloveClient;
import org.robotui.foxglove.Service;
import org.robotui.message.payload.PayloadFormat;
import org.robotui.message.payload.ReceptionRule;
import org.robotui.rfic.foxglove.internal.session.ChannelTable;
import org.robotui.rfic.foxglove.internal.session.FoxgloveTopics;
import org.robotui.rfic.foxglove.internal.session.ServerNews;

/** What a server has, as it says itself. */
public final class FoxgloveBrowser implements Browser {
  private static final String NO_GRAPH = "this server does not say who publishes and subscribes what";

  private final FoxgloveClient client;
  private final ServerNews news;
  private final FoxgloveTopics topics;
  private final FoxgloveServices services;
  private final ServerParameters parameters;

  /**
   * Creates a browser.
   *
   * @param client knows the services
   * @param news knows who is at the ends of topics
   * @param topics knows the channels
   * @param services knows how services are asked
   * @param parameters reads and sets parameters
   */
  public FoxgloveBrowser(FoxgloveClient client, ServerNews news, FoxgloveTopics topics, FoxgloveServices services,
      ServerParameters parameters) {
    this.client = client;
    this.news = news;
    this.topics = topics;
    this.services = services;
    this.parameters = parameters;
  }

  @Override
  public List<Item> list(Kind kind) throws CallException {
    return switch (kind) {
      case TOPIC -> topics().entrySet().stream().map(e -> new Item(kind, e.getKey(), e.getValue())).toList();
      case SERVICE -> client.services().stream().map(each -> new Item(kind, each.name(), each.type()))
          .sorted((a, b) -> a.name().compareTo(b.name())).toList();
      case NODE -> links().stream().map(Link::node).distinct().sorted().map(n -> new Item(kind, n, "")).toList();
      case PARAMETER -> parameters.all().keySet().stream().map(n -> new Item(kind, n, "")).toList();
      case ACTION, TUNABLE -> List.of();
    };
  }

  private Map<String, String> topics() {
    Map<String, String> types = new TreeMap<>();
    news.ends().ifPresent(ends -> Stream.of(ends.publishers(), ends.subscribers())
        .forEach(all -> all.keySet().forEach(topic -> types.put(ReceptionRule.global(topic), ""))));
    ChannelTable table = topics.table();
    table.topics().forEach(topic -> types.put(topic, table.first(topic).orElseThrow().format().type()));
    return types;
  }

  @Override
  public Description describe(Item item) throws CallException {
    return switch (item.kind()) {
      case TOPIC -> topic(item);
      case SERVICE -> service(item, services.service(item.name()));
      case NODE -> plain(item, Map.of("publishes", ofNode(item.name(), true), "subscribes",
          ofNode(item.name(), false)));
      case PARAMETER -> plain(item, Map.of("value", parameter(item.name()).map(Object::toString).orElse("not set")));
      case ACTION, TUNABLE -> throw new CallException("a server has no such thing as " + item.name());
    };
  }

  private Description topic(Item item) {
    Map<String, String> facts = new LinkedHashMap<>();
    facts.put("type", item.type());
    news.ends().ifPresent(ends -> {
      facts.put("publishers", joined(at(ends.publishers(), item.name())));
      facts.put("subscribers", joined(at(ends.subscribers(), item.name())));
    });
    Optional<ChannelTable.Offered> offered = topics.table().first(item.name());
    offered.ifPresent(each -> {
      facts.put("encoding", each.channel().encoding());
      facts.put("channels", String.valueOf(topics.table().of(item.name()).size()));
      each.format().obstacle().ifPresent(reason -> facts.put("definition", reason));
    });
    return new Description(item, facts, offered.flatMap(FoxgloveBrowser::text),
        offered.flatMap(each -> each.format().shape()), Optional.empty());
  }

  /** Descriptors are no text that users read. */
  private static Optional<String> text(ChannelTable.Offered offered) {
    return Optional.of(offered.channel().schema())
        .filter(text -> !text.isBlank() && !offered.channel().encoding().equals("protobuf"));
  }

  private Description service(Item item, Service service) {
    FoxgloveServices.Forms forms = services.forms(service);
    Map<String, String> facts = new LinkedHashMap<>();
    facts.put("type", service.type());
    facts.put("encoding", forms.source().encoding());
    Stream.of(forms.request(), forms.response()).map(PayloadFormat::obstacle).flatMap(Optional::stream).findFirst()
        .ifPresent(reason -> facts.put("definition", reason));
    Optional<RecordShape> request = forms.request().shape();
    return new Description(item, facts, Optional.of(service.request().schema() + "\n---\n"
        + service.response().schema()).filter(text -> request.isPresent()), request, forms.response().shape());
  }

  private static Description plain(Item item, Map<String, String> facts) {
    return new Description(item, facts, Optional.empty(), Optional.empty(), Optional.empty());
  }

  private static Set<String> at(Map<String, Set<String>> ends, String topic) {
    Set<String> all = new TreeSet<>();
    ends.forEach((name, ids) -> {
      if (ReceptionRule.global(name).equals(topic)) {
        all.addAll(ids);
      }
    });
    return all;
  }

  private String ofNode(String node, boolean sends) throws CallException {
    return joined(new TreeSet<>(links().stream().filter(each -> each.node().equals(node) && each.sends() == sends)
        .map(Link::topic).toList()));
  }

  private static String joined(Set<String> names) {
    return names.isEmpty() ? "none" : String.join(", ", names);
  }

  @Override
  public Optional<Object> parameter(String name) throws CallException {
    return parameters.one(name);
  }

  @Override
  public void setParameter(String name, Object value) throws CallException {
    parameters.set(name, value);
  }

  @Override
  public List<Tunable> tunables(Item item) throws CallException {
    throw new CallException("a server has no settings of programs but its parameters");
  }

  @Override
  public List<Tunable> setTunables(Item item, Map<String, Object> values) throws CallException {
    return tunables(item);
  }

  @Override
  public List<Link> links() throws CallException {
    ServerNews.Ends ends = news.ends().orElseThrow(() -> new CallException(NO_GRAPH));
    return Stream.concat(links(ends.publishers(), true), links(ends.subscribers(), false)).toList();
  }

  private static Stream<Link> links(Map<String, Set<String>> ends, boolean sends) {
    return ends.entrySet().stream().flatMap(
        topic -> topic.getValue().stream().map(node -> new Link(node, ReceptionRule.global(topic.getKey()), sends)));
  }
}
