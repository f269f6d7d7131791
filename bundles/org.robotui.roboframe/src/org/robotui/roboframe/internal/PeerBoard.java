package org.robotui.roboframe.internal;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.robotui.roboframe.link.BrokerLink;
import org.robotui.roboframe.wire.BoardKey;

/** What another application reads of what is written here. */
public final class PeerBoard {
  private final BrokerLink link;
  private Map<String, BoardKey> read = Map.of(); // guarded by this, as the following
  private List<BoardKey> all = List.of();
  private Map<String, BoardKey> written = Map.of();
  private volatile Set<String> shared = Set.of();

  public PeerBoard(BrokerLink link) {
    this.link = link;
  }

  /** Tells it the keys that are used here now; answers those that it begins to be sent. */
  public synchronized Set<String> own(Supplier<List<BoardKey>> keys) {
    List<BoardKey> now = keys.get();
    link.say(now);
    written = now.stream().filter(key -> !key.writers().isEmpty()).collect(Collectors.toMap(BoardKey::name, k -> k));
    return begun();
  }

  /** Notes the keys that it uses now; answers those that it begins to be sent. */
  public synchronized Set<String> theirs(List<BoardKey> keys) {
    all = keys;
    read = keys.stream().filter(key -> !key.readers().isEmpty())
        .collect(Collectors.toMap(BoardKey::name, k -> k, (first, again) -> first));
    return begun();
  }

  /** All keys that it uses. */
  public synchronized List<BoardKey> keys() {
    return all;
  }

  /** Whether it is sent the values of a key. */
  public boolean reads(String key) {
    return shared.contains(key);
  }

  private Set<String> begun() {
    Set<String> before = shared;
    shared = written.values().stream().filter(key -> read.containsKey(key.name()))
        .filter(key -> key.carriesWhat(read.get(key.name()))).map(BoardKey::name).collect(Collectors.toSet());
    return shared.stream().filter(key -> !before.contains(key)).collect(Collectors.toSet());
  }

  /** Sends a value, where it is read. */
  public void tell(Outgoing value) {
    if (!shared.contains(value.key())) {
      return;
    }
    if (value.every()) {
      link.queue(value.value());
    } else {
      link.push(value.value());
    }
  }
}
