package org.robotui.rfic.lcm.internal.session;

import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.robotui.api.RficContext;
import org.robotui.lcm.LcmMessage;
import org.robotui.lcm.type.TypeLibrary;
import org.robotui.rfic.lcm.internal.LcmSettings;

/** All channels that were heard or are mapped. Their names come from the network, so there is a bound. */
final class LcmChannels implements AutoCloseable {
  static final int MOST = 1000;
  /** So long silent, a channel makes room for others. */
  private static final double FORGOTTEN_SECONDS = 60;

  private final RficContext context;
  private final TypeLibrary types;
  private final SessionClock clock;
  private final Map<String, Channel> byName = new TreeMap<>();
  private long refused;
  private boolean closed;

  LcmChannels(RficContext context, LcmSettings settings, TypeLibrary types, SessionClock clock) {
    this.context = context;
    this.types = types;
    this.clock = clock;
    Map<String, List<MappedFeed<?>>> mapped =
        settings.streams().stream().<MappedFeed<?>>map(s -> MappedFeed.of(context, s, types, clock))
            .collect(Collectors.groupingBy(MappedFeed::channel));
    mapped.forEach((name, feeds) -> byName.put(name, new Channel(name, feeds, context, types, clock)));
  }

  /** A message came. */
  void accept(LcmMessage message) {
    clock.heard(message);
    channel(message.channel()).ifPresent(c -> c.accept(message));
  }

  private synchronized Optional<Channel> channel(String name) {
    if (closed) {
      return Optional.empty();
    }
    Channel known = byName.get(name);
    if (known != null) {
      return Optional.of(known);
    }
    if (byName.size() >= MOST && !makeRoom()) {
      refused++;
      return Optional.empty();
    }
    Channel channel = new Channel(name, List.of(), context, types, clock);
    byName.put(name, channel);
    return Optional.of(channel);
  }

  private boolean makeRoom() {
    Optional<Channel> idle =
        byName.values().stream().filter(c -> c.isIdle() && c.heard().silentSeconds() > FORGOTTEN_SECONDS)
            .max(Comparator.comparingDouble(c -> c.heard().silentSeconds()));
    idle.ifPresent(c -> byName.remove(c.name()).close());
    return idle.isPresent();
  }

  /** All of them, by name. */
  synchronized List<Channel> all() {
    return List.copyOf(byName.values());
  }

  synchronized Optional<Channel> find(String name) {
    return Optional.ofNullable(byName.get(name));
  }

  /** What is wanted but cannot be given; empty where all is well. */
  String problem() {
    String problems =
        all().stream().map(Channel::problem).filter(p -> !p.isEmpty()).distinct().collect(Collectors.joining("; "));
    long left = refused();
    return left == 0 ? problems
        : problems + (problems.isEmpty() ? "" : "; ") + left + " messages came on channels beyond " + MOST
            + ", which are left out";
  }

  private synchronized long refused() {
    return refused;
  }

  @Override
  public void close() {
    List<Channel> all;
    synchronized (this) {
      closed = true;
      all = List.copyOf(byName.values());
    }
    all.forEach(Channel::close);
  }
}
