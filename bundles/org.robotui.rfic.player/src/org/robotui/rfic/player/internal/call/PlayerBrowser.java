package org.robotui.rfic.player.internal.call;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.stream.Stream;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CallException;
import org.robotui.net.call.Outcome;
import org.robotui.player.client.DeviceState;
import org.robotui.player.client.PlayerClient;
import org.robotui.player.layout.Layouts;
import org.robotui.player.layout.MessageLayout;
import org.robotui.player.wire.DeviceAddress;
import org.robotui.player.wire.MessageType;
import org.robotui.rfic.player.internal.convert.PlayerShapes;
import org.robotui.rfic.player.internal.device.DeviceFeed;
import org.robotui.rfic.player.internal.link.Devices;

/**
 * What a server has: its devices' messages as topics, requests as services, and its drivers as nodes. Nothing is
 * subscribed for it.
 */
public final class PlayerBrowser implements Browser {
  private static final Duration PATIENCE = Duration.ofSeconds(4);
  private static final String ANSWER = "\n---\n";

  private final PlayerClient client;
  private final Devices devices;
  private final Layouts layouts;

  public PlayerBrowser(PlayerClient client, Devices devices, Layouts layouts) {
    this.client = client;
    this.devices = devices;
    this.layouts = layouts;
  }

  @Override
  public List<Item> list(Kind kind) throws CallException {
    return switch (kind) {
      case TOPIC -> topics().map(t -> new Item(kind, t.name(), t.type())).sorted(Comparator.comparing(Item::name))
          .toList();
      case SERVICE -> Callable.all(devices, layouts).stream().map(c -> new Item(kind, c.name(), type(c.message())))
          .sorted(Comparator.comparing(Item::name)).toList();
      case NODE -> drivers().keySet().stream().map(n -> new Item(kind, n, "")).toList();
      case PARAMETER, ACTION, TUNABLE -> List.of();
    };
  }

  /** A kind of data or command of a device; of an interface that is not known, all its data. */
  private record Topic(DeviceFeed feed, Optional<MessageLayout> message) {
    String name() {
      return message.map(m -> feed.name() + "/" + m.name()).orElseGet(feed::name);
    }

    String type() {
      return message.map(PlayerBrowser::type).orElse("bytes");
    }

    boolean sends() {
      return message.filter(m -> m.type() == MessageType.COMMAND).isEmpty();
    }
  }

  private Stream<Topic> topics() {
    return devices.all().values().stream().flatMap(feed -> {
      List<MessageLayout> data = feed.messages(MessageType.DATA);
      List<MessageLayout> commands = feed.messages(MessageType.COMMAND);
      boolean known = layouts.byCode(feed.device().id().interfaceCode()).isPresent();
      return known
          ? Stream
              .concat(data.stream(),
                  commands.stream().filter(c -> data.stream().noneMatch(d -> d.name().equals(c.name()))))
              .map(m -> new Topic(feed, Optional.of(m)))
          : Stream.of(new Topic(feed, Optional.empty()));
    });
  }

  private static String type(MessageLayout message) {
    return message.payload().map(p -> p.name()).orElse("empty");
  }

  @Override
  public Description describe(Item item) throws CallException {
    return switch (item.kind()) {
      case TOPIC -> topic(item);
      case SERVICE -> service(item);
      case NODE -> driver(item);
      default -> throw gone(item);
    };
  }

  private Description topic(Item item) throws CallException {
    Topic topic = topics().filter(t -> t.name().equals(item.name())).findFirst().orElseThrow(() -> gone(item));
    Map<String, String> facts = facts(topic.feed());
    facts.put("direction", topic.sends() ? "from the device" : "to the device");
    topic.message().map(MessageLayout::comment).filter(c -> !c.isEmpty()).ifPresent(c -> facts.put("meaning", c));
    if (topic.message().isEmpty()) {
      facts.put("definition", "interface " + topic.feed().device().id().interfaceCode()
          + " is not known here; its data are shown as bytes");
    }
    return new Description(item, facts, topic.message().map(m -> PlayerShapes.text(m.payload())),
        topic.message().map(m -> PlayerShapes.of(m.payload())), Optional.empty());
  }

  private Description service(Item item) throws CallException {
    Callable callable = Callable.find(item.name(), devices, layouts).orElseThrow(() -> gone(item));
    MessageLayout message = callable.message();
    Map<String, String> facts = facts(callable.feed());
    facts.put("answered", message.type() == MessageType.COMMAND ? "never: it is a command" : "by the driver");
    if (!message.comment().isEmpty()) {
      facts.put("meaning", message.comment());
    }
    return new Description(item, facts,
        Optional.of(PlayerShapes.text(message.payload()) + ANSWER + PlayerShapes.text(message.answer())),
        Optional.of(PlayerShapes.of(message.payload())), Optional.of(PlayerShapes.of(message.answer())));
  }

  private Description driver(Item item) throws CallException {
    List<String> moved = Optional.ofNullable(drivers().get(item.name())).orElseThrow(() -> gone(item));
    return new Description(item, Map.of("devices", String.join(", ", moved)), Optional.empty(), Optional.empty(),
        Optional.empty());
  }

  private static Map<String, String> facts(DeviceFeed feed) {
    Map<String, String> facts = new LinkedHashMap<>();
    facts.put("device", feed.name());
    facts.put("subscription", switch (feed.device().state()) {
      case DeviceState.Unused u -> "not open: nobody here looks at it";
      case DeviceState.Waiting w -> "being opened";
      case DeviceState.Open o -> "open" + (o.driver().isEmpty() ? "" : ", driver " + o.driver());
      case DeviceState.Refused r -> r.reason();
    });
    return facts;
  }

  /** The devices of each driver; asking for drivers opens nothing. */
  private Map<String, List<String>> drivers() throws CallException {
    Map<String, CompletableFuture<Outcome<String>>> asked = new LinkedHashMap<>();
    for (DeviceAddress address : client.devices()) {
      String name = layouts.nameOf(address);
      if (devices.find(name).isPresent()) {
        asked.putIfAbsent(name, client.driver(address));
      }
    }
    Map<String, List<String>> drivers = new TreeMap<>();
    long deadline = System.nanoTime() + PATIENCE.toNanos();
    for (Map.Entry<String, CompletableFuture<Outcome<String>>> each : asked.entrySet()) {
      String driver = await(each.getValue(), deadline).toOptional().filter(d -> !d.isEmpty()).orElse("unknown driver");
      drivers.computeIfAbsent(driver, d -> new ArrayList<>()).add(each.getKey());
    }
    return drivers;
  }

  private static Outcome<String> await(CompletableFuture<Outcome<String>> future, long deadline) throws CallException {
    try {
      return future.get(Math.max(1, deadline - System.nanoTime()), TimeUnit.NANOSECONDS);
    } catch (TimeoutException | ExecutionException e) {
      throw new CallException("the server does not tell its drivers", e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new CallException("given up", e);
    }
  }

  @Override
  public List<Link> links() throws CallException {
    List<Link> links = new ArrayList<>();
    drivers().forEach((driver, moved) -> topics().filter(t -> moved.contains(t.feed().name()))
        .forEach(t -> links.add(new Link(driver, t.name(), t.sends()))));
    return links;
  }

  @Override
  public Optional<Object> parameter(String name) throws CallException {
    throw noParameters();
  }

  @Override
  public void setParameter(String name, Object value) throws CallException {
    throw noParameters();
  }

  private static CallException noParameters() {
    return new CallException(
        "Player lists no settings; those of a device whose names you know are read and set by the calls get_..._property");
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
    return new CallException("the server has no " + item.name() + " (any more)");
  }
}
