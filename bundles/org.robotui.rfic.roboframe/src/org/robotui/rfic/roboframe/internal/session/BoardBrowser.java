package org.robotui.rfic.roboframe.internal.session;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CallException;
import org.robotui.roboframe.link.BrokerLink;

/** What an application has, as it says itself: keys are topics, modules are nodes. */
final class BoardBrowser implements Browser {
  private final BrokerLink link;
  private final RoboframeTopics topics;

  BoardBrowser(BrokerLink link, RoboframeTopics topics) {
    this.link = link;
    this.topics = topics;
  }

  @Override
  public List<Item> list(Kind kind) {
    return switch (kind) {
      case TOPIC -> topics.board().keys().values().stream()
          .map(all -> new Item(kind, "/" + all.getFirst().key().name(), all.getFirst().format().type())).toList();
      case NODE -> links().stream().map(Link::node).distinct().sorted().map(name -> new Item(kind, name, "")).toList();
      case SERVICE, PARAMETER, ACTION, TUNABLE -> List.of();
    };
  }

  @Override
  public Description describe(Item item) throws CallException {
    return switch (item.kind()) {
      case TOPIC -> topic(item);
      case NODE -> new Description(item, Map.of("application", link.application().orElse(""), "publishes",
          ofModule(item.name(), true), "subscribes", ofModule(item.name(), false)), Optional.empty(),
          Optional.empty(), Optional.empty());
      default -> throw new CallException("an application of RoboFrame has no such thing as " + item.name());
    };
  }

  private Description topic(Item item) throws CallException {
    OfferedKey offered = topics.board().first(item.name())
        .orElseThrow(() -> new CallException("no module uses " + item.name() + " any more"));
    Map<String, String> facts = new LinkedHashMap<>();
    facts.put("type", item.type());
    facts.put("publishers",
        topics.board().written(item.name()).map(each -> joined(each.key().writers())).orElse("none"));
    facts.put("subscribers", topics.board().read(item.name()).map(each -> joined(each.key().readers())).orElse("none"));
    offered.format().obstacle().ifPresent(reason -> facts.put("definition", reason));
    return new Description(item, facts, Optional.of(offered.key().definition()), offered.format().shape(),
        Optional.empty());
  }

  private String ofModule(String module, boolean sends) {
    return joined(links().stream().filter(each -> each.node().equals(module) && each.sends() == sends)
        .map(Link::topic).toList());
  }

  private static String joined(List<String> names) {
    return names.isEmpty() ? "none" : String.join(", ", new TreeSet<>(names));
  }

  @Override
  public List<Link> links() {
    return topics.board().all().flatMap(each -> Stream.concat(links(each, each.key().writers(), true),
        links(each, each.key().readers(), false))).toList();
  }

  private static Stream<Link> links(OfferedKey offered, List<String> modules, boolean sends) {
    return modules.stream().map(module -> new Link(module, "/" + offered.key().name(), sends));
  }

  @Override
  public Optional<Object> parameter(String name) throws CallException {
    throw new CallException("an application of RoboFrame has no parameters");
  }

  @Override
  public void setParameter(String name, Object value) throws CallException {
    parameter(name);
  }

  @Override
  public List<Tunable> tunables(Item item) throws CallException {
    throw new CallException("an application of RoboFrame has no settings of modules");
  }

  @Override
  public List<Tunable> setTunables(Item item, Map<String, Object> values) throws CallException {
    return tunables(item);
  }
}
