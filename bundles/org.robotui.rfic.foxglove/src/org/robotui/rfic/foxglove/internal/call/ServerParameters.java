package org.robotui.rfic.foxglove.internal.call;

import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.robotui.api.port.CallException;
import org.robotui.foxglove.FoxgloveClient;
import org.robotui.foxglove.Parameter;
import org.robotui.foxglove.ServerInfo;
import org.robotui.message.payload.JsonValues;
import org.robotui.message.topic.CallOutcomes;
import org.robotui.rfic.foxglove.internal.session.ServerNews;

/**
 * Parameters of a server. Where it says when they change, they are followed from the first question until nobody has
 * asked for a while, and only asked for once. Safe for all threads.
 */
public final class ServerParameters implements AutoCloseable {
  private static final Duration IDLE = Duration.ofSeconds(20);
  private static final Duration PATIENCE = Duration.ofSeconds(3);

  private final FoxgloveClient client;
  private final ServerNews news;
  private List<String> followed = List.of();
  private long askedAt;

  /**
   * Nothing was asked yet.
   *
   * @param client asks
   * @param news hears of changes
   */
  public ServerParameters(FoxgloveClient client, ServerNews news) {
    this.client = client;
    this.news = news;
  }

  /** All that are set, by name. */
  synchronized Map<String, Object> all() throws CallException {
    check();
    Map<String, Object> values = new TreeMap<>();
    for (Parameter each : CallOutcomes.asked(() -> client.parameters(List.of(), PATIENCE))) {
      values.put(each.name(), JsonValues.listed(each.value()));
    }
    follow(values);
    return values;
  }

  private void check() throws CallException {
    if (!client.info().map(info -> info.can(ServerInfo.PARAMETERS)).orElse(false)) {
      throw new CallException("this server offers no parameters");
    }
  }

  private void follow(Map<String, Object> values) {
    askedAt = System.nanoTime();
    if (!client.info().map(info -> info.can(ServerInfo.PARAMETERS_SUBSCRIBE)).orElse(false)) {
      return;
    }
    List<String> names = List.copyOf(values.keySet());
    if (!names.equals(followed)) {
      client.followParameters(names, true);
      followed = names;
    }
    news.parameters().clear();
    news.parameters().putAll(values);
  }

  synchronized Optional<Object> one(String name) throws CallException {
    askedAt = System.nanoTime();
    if (followed.contains(name)) {
      return Optional.ofNullable(news.parameters().get(name)).map(JsonValues::listed);
    }
    return Optional.ofNullable(all().get(name));
  }

  synchronized void set(String name, Object value) throws CallException {
    check();
    Map<String, Object> now = new HashMap<>();
    CallOutcomes.asked(() -> client.set(Parameter.of(name, value), PATIENCE))
        .forEach(each -> now.put(each.name(), each.value()));
    news.parameters().putAll(now);
    if (now.containsKey(name) && !same(JsonValues.listed(now.get(name)), value)) {
      throw new CallException(
          name + " stays " + JsonValues.listed(now.get(name)) + ": the server did not take " + value);
    }
  }

  private static boolean same(Object now, Object wanted) {
    return now instanceof Number a && wanted instanceof Number b ? a.doubleValue() == b.doubleValue()
        : now.equals(JsonValues.listed(wanted));
  }

  /** Follows no more what nobody has asked for lately. */
  public synchronized void tick() {
    if (!followed.isEmpty() && System.nanoTime() - askedAt > IDLE.toNanos()) {
      close();
    }
  }

  @Override
  public synchronized void close() {
    if (!followed.isEmpty()) {
      client.followParameters(followed, false);
      followed = List.of();
    }
  }
}
