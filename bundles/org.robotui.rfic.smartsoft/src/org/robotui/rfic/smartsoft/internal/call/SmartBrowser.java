package org.robotui.rfic.smartsoft.internal.call;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.TreeSet;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CallException;
import org.robotui.data.record.RecordShape;
import org.robotui.message.DefinitionException;
import org.robotui.message.data.MessageShapes;
import org.robotui.rfic.smartsoft.internal.feed.SmartServices;
import org.robotui.smartsoft.client.QueryClient;
import org.robotui.smartsoft.client.StateMaster;
import org.robotui.smartsoft.naming.NamedService;
import org.robotui.smartsoft.naming.ServiceName;
import org.robotui.smartsoft.naming.SmartPattern;
import org.robotui.smartsoft.object.CommTypes;
import org.robotui.smartsoft.wire.LinkOptions;

/**
 * What a naming service knows: what comes as topics, what can be asked and told as services, components as nodes. The
 * main state of a component is a parameter. Parameters of SmartSoft's own pattern can only be sent, so they are calls.
 */
public final class SmartBrowser implements Browser {
  private static final Duration PATIENCE = Duration.ofSeconds(5);

  private final SmartServices services;
  private final CommTypes types;
  private final LinkOptions links;

  public SmartBrowser(SmartServices services, CommTypes types, LinkOptions links) {
    this.services = services;
    this.types = types;
    this.links = links;
  }

  @Override
  public List<Item> list(Kind kind) {
    return switch (kind) {
      case TOPIC -> items(kind, SmartBrowser::comes);
      case SERVICE -> items(kind, SmartCalls::takes);
      case PARAMETER -> items(kind, SmartBrowser::isState);
      case NODE -> new TreeSet<>(services.known().values().stream().map(each -> each.name().component()).toList())
          .stream().map(component -> new Item(kind, component, "")).toList();
      case ACTION, TUNABLE -> List.of();
    };
  }

  private static boolean comes(ServiceName name) {
    return name.known().filter(pattern -> pattern == SmartPattern.PUSH || pattern == SmartPattern.EVENT).isPresent();
  }

  private static boolean isState(ServiceName name) {
    return name.known().equals(Optional.of(SmartPattern.QUERY)) && name.types().getFirst().equals(StateMaster.REQUEST);
  }

  private interface Which {
    boolean fits(ServiceName name);
  }

  private List<Item> items(Kind kind, Which which) {
    List<Item> items = new ArrayList<>();
    new TreeMap<>(services.known()).forEach((path, service) -> {
      if (which.fits(service.name())) {
        items.add(new Item(kind, path, kind == Kind.PARAMETER ? "" : String.join(", ", service.name().types())));
      }
    });
    return items;
  }

  @Override
  public Description describe(Item item) throws CallException {
    return switch (item.kind()) {
      case NODE -> component(item);
      case PARAMETER -> state(item);
      default -> service(item);
    };
  }

  private Description component(Item item) {
    Map<String, String> facts = new LinkedHashMap<>();
    new TreeMap<>(services.known()).values().stream().filter(each -> each.name().component().equals(item.name()))
        .forEach(each -> facts.put(each.name().service(),
            each.name().pattern() + " of " + String.join(", ", each.name().types())));
    return new Description(item, facts, Optional.empty(), Optional.empty(), Optional.empty());
  }

  private Description state(Item item) throws CallException {
    try (QueryClient client = connect(item.name())) {
      StateMaster master = new StateMaster(client, types, PATIENCE);
      Map<String, String> facts = new LinkedHashMap<>();
      facts.put("value", master.current());
      facts.put("choices", String.join(", ", master.all()));
      return new Description(item, facts, Optional.empty(), Optional.empty(), Optional.empty());
    } catch (IOException e) {
      throw new CallException(e.getMessage(), e);
    }
  }

  private Description service(Item item) throws CallException {
    NamedService service = services.find(item.name()).orElseThrow(() -> gone(item));
    Map<String, String> facts = new LinkedHashMap<>();
    facts.put("component", service.name().component());
    facts.put("pattern", service.name().pattern());
    facts.put("address", service.address().at().toString());
    boolean two = service.name().types().size() > 1;
    String first = service.name().types().getFirst();
    String last = service.name().types().getLast();
    try {
      Optional<RecordShape> in = Optional.of(MessageShapes.of(services.described(first).schema()));
      Optional<RecordShape> out = two ? Optional.of(MessageShapes.of(services.described(last).schema()))
          : Optional.empty();
      return new Description(item, facts, Optional.of(text(service.name().types())), in, out);
    } catch (DefinitionException e) {
      facts.put("objects", e.getMessage());
      return new Description(item, facts, Optional.empty(), Optional.empty(), Optional.empty());
    }
  }

  private String text(List<String> names) throws DefinitionException {
    List<String> texts = new ArrayList<>();
    for (String name : names) {
      texts.add("# " + name + "\n" + services.described(name).schema().definition().text());
    }
    return String.join("---\n", texts);
  }

  @Override
  public List<Link> links() {
    return services.known().values().stream().filter(each -> comes(each.name()))
        .map(each -> new Link(each.name().component(), each.name().path(), true)).toList();
  }

  private QueryClient connect(String path) throws CallException, IOException {
    NamedService service = services.find(path).filter(each -> isState(each.name())).orElseThrow(
        () -> new CallException("'" + path + "' is no state of a component; they are called as in base/state"));
    return QueryClient.connect(service.address(), links);
  }

  @Override
  public Optional<Object> parameter(String name) throws CallException {
    try (QueryClient client = connect(name)) {
      return Optional.of(new StateMaster(client, types, PATIENCE).current());
    } catch (IOException e) {
      throw new CallException(e.getMessage(), e);
    }
  }

  @Override
  public void setParameter(String name, Object value) throws CallException {
    try (QueryClient client = connect(name)) {
      new StateMaster(client, types, PATIENCE).change(String.valueOf(value));
    } catch (IOException e) {
      throw new CallException(e.getMessage(), e);
    }
  }

  @Override
  public List<Tunable> tunables(Item item) throws CallException {
    throw gone(item);
  }

  @Override
  public List<Tunable> setTunables(Item item, Map<String, Object> values) throws CallException {
    throw gone(item);
  }

  private static CallException gone(Item item) {
    return new CallException("the naming service has no " + item.name() + " (any more)");
  }
}
