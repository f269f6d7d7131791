package org.robotui.uic.parameters.internal.model;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.robotui.api.port.BrowseInput;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CallException;
import org.robotui.api.port.SourceId;

/** A robot with the parameters and settings that a test gives it. */
public final class FakeRobot implements Browser {
  private final Map<String, Object> parameters = new TreeMap<>();
  private final Map<String, List<Tunable>> servers = new TreeMap<>();
  private final List<Map<String, Object>> sent = new ArrayList<>();
  private Optional<String> failure = Optional.empty();
  private Optional<String> refusal = Optional.empty();
  private int reads;
  private int polls;

  public BrowseInput.Robot robot(String component) {
    return new BrowseInput.Robot(new SourceId(component, "graph"), this);
  }

  public synchronized FakeRobot with(String name, Object value) {
    parameters.put(name, value);
    return this;
  }

  public synchronized FakeRobot server(String name, Tunable... tunables) {
    servers.put(name, List.of(tunables));
    return this;
  }

  public synchronized void fail(Optional<String> reason) {
    failure = reason;
  }

  public synchronized void refuse(Optional<String> reason) {
    refusal = reason;
  }

  public synchronized Object value(String name) {
    return parameters.get(name);
  }

  public synchronized int reads() {
    return reads;
  }

  public synchronized int polls() {
    return polls;
  }

  public synchronized List<Map<String, Object>> sent() {
    return List.copyOf(sent);
  }

  public static Tunable number(String name, String group, double value, double fallback, double least, double most,
      String help) {
    return new Tunable(name, group, help, value, fallback, Optional.of(least), Optional.of(most), List.of());
  }

  public static Tunable whole(String name, String group, long value, long fallback, long least, long most,
      String help) {
    return new Tunable(name, group, help, value, fallback, Optional.of(least), Optional.of(most), List.of());
  }

  public static Tunable plain(String name, String group, Object value, Object fallback, String help) {
    return new Tunable(name, group, help, value, fallback, Optional.empty(), Optional.empty(), List.of());
  }

  public static Tunable choice(String name, long value, long fallback, String help, Choice... choices) {
    return new Tunable(name, "", help, value, fallback, Optional.empty(), Optional.empty(), List.of(choices));
  }

  public synchronized void elsewhere(String server, String name, Object value) {
    servers.computeIfPresent(server,
        (s, all) -> all.stream().map(t -> t.name().equals(name) ? changed(t, value) : t).toList());
  }

  private static Tunable changed(Tunable t, Object value) {
    return new Tunable(t.name(), t.group(), t.help(), value, t.fallback(), t.least(), t.most(), t.choices());
  }

  @Override
  public synchronized List<Item> list(Kind kind) throws CallException {
    check(failure);
    return switch (kind) {
      case PARAMETER -> parameters.keySet().stream().map(name -> new Item(kind, name, "")).toList();
      case TUNABLE -> servers.keySet().stream().map(name -> new Item(kind, name, "")).toList();
      default -> List.of();
    };
  }

  @Override
  public Description describe(Item item) {
    return new Description(item, Map.of(), Optional.empty(), Optional.empty(), Optional.empty());
  }

  @Override
  public synchronized Optional<Object> parameter(String name) throws CallException {
    reads++;
    check(failure);
    return Optional.ofNullable(parameters.get(name));
  }

  @Override
  public synchronized void setParameter(String name, Object value) throws CallException {
    check(failure);
    check(refusal);
    parameters.put(name, value);
  }

  @Override
  public synchronized List<Tunable> tunables(Item item) throws CallException {
    polls++;
    check(failure);
    return servers.get(item.name());
  }

  @Override
  public synchronized List<Tunable> setTunables(Item item, Map<String, Object> values) throws CallException {
    check(failure);
    check(refusal);
    sent.add(new LinkedHashMap<>(values));
    values.forEach((name, value) -> elsewhere(item.name(), name, value));
    return servers.get(item.name());
  }

  private static void check(Optional<String> reason) throws CallException {
    if (reason.isPresent()) {
      throw new CallException(reason.get());
    }
  }
}
