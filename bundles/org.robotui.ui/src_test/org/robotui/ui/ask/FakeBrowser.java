package org.robotui.ui.ask;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CallException;
import org.robotui.data.record.FieldShape;
import org.robotui.data.record.RecordShape;

/** A robot with what a test gives it. */
final class FakeBrowser implements Browser {
  List<Item> items = List.of();
  Optional<String> refusal = Optional.empty();
  int lists;

  @Override
  public List<Item> list(Kind kind) throws CallException {
    lists++;
    check();
    return items;
  }

  @Override
  public Description describe(Item item) throws CallException {
    check();
    RecordShape shape =
        new RecordShape(item.type(), List.of(new RecordShape.Field("data", new FieldShape.Flag())), List.of());
    return new Description(item, Map.of("type", item.type()), Optional.empty(), Optional.of(shape), Optional.empty());
  }

  private void check() throws CallException {
    if (refusal.isPresent()) {
      throw new CallException(refusal.get());
    }
  }

  @Override
  public Optional<Object> parameter(String name) {
    return Optional.empty();
  }

  @Override
  public void setParameter(String name, Object value) {
    throw new UnsupportedOperationException(name);
  }

  @Override
  public List<Tunable> tunables(Item item) {
    return List.of();
  }

  @Override
  public List<Tunable> setTunables(Item item, Map<String, Object> values) {
    return List.of();
  }
}
