package org.robotui.lcm.internal.client;

import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import org.robotui.lcm.LcmMessage;

/** Who hears of which channel. */
final class Subscriptions implements Inlet {

  /** Names come from peers: no more of them are remembered. */
  private static final int MOST_REMEMBERED = 4096;

  private final Counters counters;
  private final List<LiveSubscription> all = new CopyOnWriteArrayList<>();
  /** A new one for each change, so that nothing old gets into it. */
  private volatile Map<String, List<LiveSubscription>> byChannel = new ConcurrentHashMap<>();

  Subscriptions(Counters counters) {
    this.counters = counters;
  }

  void add(LiveSubscription subscription) {
    all.add(subscription);
    byChannel = new ConcurrentHashMap<>();
  }

  boolean remove(LiveSubscription subscription) {
    boolean removed = all.remove(subscription);
    byChannel = new ConcurrentHashMap<>();
    return removed;
  }

  List<LiveSubscription> all() {
    return all;
  }

  @Override
  public boolean wants(String channel) {
    return !of(channel).isEmpty();
  }

  @Override
  public void deliver(LcmMessage message) {
    List<LiveSubscription> subscriptions = of(message.channel());
    if (!subscriptions.isEmpty()) {
      counters.received(message.data().remaining());
      subscriptions.forEach(each -> each.deliver(message));
    }
  }

  @Override
  public Counters counters() {
    return counters;
  }

  private List<LiveSubscription> of(String channel) {
    Map<String, List<LiveSubscription>> memory = byChannel;
    List<LiveSubscription> known = memory.get(channel);
    if (known != null) {
      return known;
    }
    List<LiveSubscription> found = all.stream().filter(each -> each.matches(channel)).toList();
    if (memory.size() < MOST_REMEMBERED) {
      memory.put(channel, found);
    }
    return found;
  }
}
