package org.robotui.uic.topics.internal.model;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.port.BrowseInput;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CallException;
import org.robotui.api.port.SourceId;
import org.robotui.data.record.FieldShape;
import org.robotui.data.record.RecordShape;

/** A robot with what a test gives it. */
public final class FakeGraph implements Browser {
  private final Map<Kind, List<Item>> items = new EnumMap<>(Kind.class);
  private final Map<String, Description> descriptions = new LinkedHashMap<>();
  private Optional<String> failure = Optional.empty();
  private int listed;
  private int described;

  public BrowseInput.Robot robot(String component) {
    return new BrowseInput.Robot(new SourceId(component, "graph"), this);
  }

  public synchronized FakeGraph add(Kind kind, String name, String type) {
    items.computeIfAbsent(kind, k -> new ArrayList<>()).add(new Item(kind, name, type));
    return this;
  }

  public synchronized FakeGraph remove(Kind kind, String name) {
    items.get(kind).removeIf(item -> item.name().equals(name));
    return this;
  }

  public synchronized FakeGraph describe(Kind kind, String name, String type, Map<String, String> facts,
      String definition,
      Optional<RecordShape> shape) {
    Item item = new Item(kind, name, type);
    descriptions.put(name,
        new Description(item, facts, Optional.of(definition).filter(d -> !d.isEmpty()), shape, Optional.empty()));
    return this;
  }

  public synchronized void fail(Optional<String> reason) {
    failure = reason;
  }

  public synchronized int listed() {
    return listed;
  }

  public synchronized int described() {
    return described;
  }

  /** Two thousand topics and two hundred nodes. */
  public static FakeGraph large() {
    FakeGraph graph = new FakeGraph();
    for (int i = 0; i < 2000; i++) {
      graph.add(Kind.TOPIC, "/robot%03d/part/topic%02d".formatted(i / 10, i % 10), "std_msgs/Float64");
    }
    for (int i = 0; i < 200; i++) {
      graph.add(Kind.NODE, "/robot%03d/node".formatted(i), "");
    }
    return graph;
  }

  public static RecordShape twist() {
    FieldShape number = new FieldShape.Real(64);
    RecordShape vector = new RecordShape("geometry_msgs/Vector3",
        List.of(new RecordShape.Field("x", number), new RecordShape.Field("y", number),
            new RecordShape.Field("z", number)),
        List.of());
    return new RecordShape("geometry_msgs/Twist",
        List.of(new RecordShape.Field("linear", new FieldShape.Nested(vector)),
            new RecordShape.Field("angular", new FieldShape.Nested(vector))),
        List.of());
  }

  @Override
  public synchronized List<Item> list(Kind kind) throws CallException {
    listed++;
    check();
    return List.copyOf(items.getOrDefault(kind, List.of()));
  }

  @Override
  public synchronized Description describe(Item item) throws CallException {
    described++;
    check();
    return descriptions.getOrDefault(item.name(),
        new Description(item, Map.of(), Optional.empty(), Optional.empty(), Optional.empty()));
  }

  private void check() throws CallException {
    if (failure.isPresent()) {
      throw new CallException(failure.get());
    }
  }

  @Override
  public Optional<Object> parameter(String name) {
    return Optional.empty();
  }

  @Override
  public void setParameter(String name, Object value) throws CallException {
    throw new CallException("not in this test");
  }

  @Override
  public List<Tunable> tunables(Item item) {
    return List.of();
  }

  @Override
  public List<Tunable> setTunables(Item item, Map<String, Object> values) throws CallException {
    throw new CallException("not in this test");
  }
}
