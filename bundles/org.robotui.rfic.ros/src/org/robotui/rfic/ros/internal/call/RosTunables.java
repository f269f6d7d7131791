package org.robotui.rfic.ros.internal.call;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.robotui.api.port.Browser.Choice;
import org.robotui.api.port.Browser.Tunable;
import org.robotui.api.port.CallException;
import org.robotui.message.topic.CallOutcomes;
import org.robotui.message.topic.KeptWhileAsked;
import org.robotui.ros.GraphName;
import org.robotui.ros.RosNode;
import org.robotui.ros.reconfigure.ConfigGroup;
import org.robotui.ros.reconfigure.ConfigParameter;
import org.robotui.ros.reconfigure.ConfigValue;
import org.robotui.ros.reconfigure.ConfigValues;
import org.robotui.ros.reconfigure.ReconfigureClient;
import org.robotui.ros.reconfigure.ReconfigureListener;
import org.robotui.ros.reconfigure.ServerDescription;

/** Settings of running nodes. A node is listened to from the first question until nobody has asked for a while. */
public final class RosTunables implements AutoCloseable {
  private static final Duration PATIENCE = Duration.ofSeconds(3);

  private final KeptWhileAsked<String, ReconfigureClient> servers;

  /**
   * Creates a reader.
   *
   * @param node asks
   */
  public RosTunables(RosNode node) {
    this.servers = new KeptWhileAsked<>(
        name -> ReconfigureClient.open(node, GraphName.of(name), ReconfigureListener.none()), ReconfigureClient::close);
  }

  List<Tunable> read(String server) throws CallException {
    ReconfigureClient client = servers.of(server);
    return tunables(server, client, client.values());
  }

  List<Tunable> change(String server, Map<String, Object> values) throws CallException {
    ReconfigureClient client = servers.of(server);
    client.await(PATIENCE);
    ConfigValues now = CallOutcomes.value(client.set(values, PATIENCE));
    return tunables(server, client, Optional.of(now));
  }

  private static List<Tunable> tunables(String server, ReconfigureClient client, Optional<ConfigValues> values)
      throws CallException {
    if (values.isEmpty() && !client.await(PATIENCE)) {
      throw new CallException(server + " has not told its settings within " + PATIENCE.toSeconds() + " s");
    }
    ServerDescription description = client.description()
        .orElseThrow(() -> new CallException(server + " has not described its settings"));
    ConfigValues now = values.or(client::values)
        .orElseThrow(() -> new CallException(server + " has not told the values of its settings"));
    Map<Integer, ConfigGroup> groups =
        description.groups().stream().collect(Collectors.toMap(ConfigGroup::id, g -> g, (a, b) -> a));
    List<Tunable> all = new ArrayList<>();
    description.groups()
        .forEach(g -> g.parameters().forEach(p -> tunable(p, path(g, groups), now).ifPresent(all::add)));
    return List.copyOf(all);
  }

  private static Optional<Tunable> tunable(ConfigParameter p, String group, ConfigValues values) {
    Optional<Object> value = Optional.ofNullable(values.values().get(p.name())).map(RosTunables::plain);
    return value
        .map(v -> new Tunable(p.name(), group, p.description(), v, p.initial().map(RosTunables::plain).orElse(v),
            p.min().map(RosTunables::plain), p.max().map(RosTunables::plain),
            p.choices().stream().map(c -> new Choice(c.name(), plain(c.value()), c.description())).toList()));
  }

  private static Object plain(ConfigValue value) {
    return value instanceof ConfigValue.Whole whole ? (Object) (long) whole.value() : value.toJava();
  }

  /** What a server sends need not be a tree. */
  private static String path(ConfigGroup of, Map<Integer, ConfigGroup> groups) {
    List<String> names = new ArrayList<>();
    Set<Integer> seen = new HashSet<>();
    Optional<ConfigGroup> at = Optional.of(of);
    while (at.isPresent() && at.get().id() != at.get().parent() && seen.add(at.get().id())) {
      names.addFirst(at.get().name());
      at = Optional.ofNullable(groups.get(at.get().parent()));
    }
    return String.join("/", names);
  }

  /** Listens no more to those of whom nobody has asked for a while. */
  public void tick() {
    servers.tick();
  }

  @Override
  public void close() {
    servers.close();
  }
}
