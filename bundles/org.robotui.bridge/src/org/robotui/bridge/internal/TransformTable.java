package org.robotui.bridge.internal;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.robotui.api.bridge.BridgeTransform;

/** The transforms that are installed now. Safe for all threads. */
public final class TransformTable {
  private final List<BridgeTransform> all = new CopyOnWriteArrayList<>();

  void add(BridgeTransform transform) {
    all.add(transform);
  }

  void remove(BridgeTransform transform) {
    all.remove(transform);
  }

  /** A transform by its id. */
  public Optional<BridgeTransform> find(String id) {
    return all.stream().filter(t -> t.id().equals(id)).findFirst();
  }

  /** The ids of all. */
  public List<String> ids() {
    return all.stream().map(BridgeTransform::id).sorted().toList();
  }
}
