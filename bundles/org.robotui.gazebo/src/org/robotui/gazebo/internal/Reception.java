package org.robotui.gazebo.internal;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.robotui.gazebo.internal.DiscoveryMessage.Announcement;
import org.robotui.gazebo.internal.DiscoveryMessage.Ends;
import org.robotui.gazebo.internal.DiscoveryMessage.Kind;
import org.robotui.gazebo.internal.DiscoveryMessage.Scope;
import org.robotui.web.Arrivals;
import org.zeromq.ZMQ;

/**
 * What is received: a publisher is connected to while somebody wants a topic of it, and told so by discovery, as it
 * publishes only what somebody has asked for. Safe for all threads.
 */
final class Reception {
  private static final int PARTS = 4;
  private static final long LAST_WORDS = Duration.ofMillis(500).toNanos();

  private final SocketLoop loop;
  private final NodeSockets sockets;
  private final PendingSends pending;
  private final Identity own;
  private final Map<String, List<Wanted>> wanted = new HashMap<>();
  private final Map<String, Set<Announcement>> connections = new HashMap<>();
  private Optional<Discovery> discovery = Optional.empty();

  /** Who receives. */
  record Identity(String process, String node) {}

  /** A message as it came. */
  record Received(String sender, ByteBuffer payload, long nanos) {}

  /** Somebody who wants a topic. */
  record Wanted(String topic, String type, Arrivals.Source<Received> source) {}

  Reception(SocketLoop loop, NodeSockets sockets, PendingSends pending, Identity own) {
    this.loop = loop;
    this.sockets = sockets;
    this.pending = pending;
    this.own = own;
  }

  synchronized void tellBy(Discovery told) {
    discovery = Optional.of(told);
  }

  synchronized Optional<Discovery> tellBy() {
    return discovery;
  }

  synchronized void add(Wanted each, List<Announcement> publishers) {
    List<Wanted> all = wanted.computeIfAbsent(each.topic(), topic -> new ArrayList<>());
    all.add(each);
    if (all.size() == 1) {
      loop.leave(() -> sockets.filter(each.topic(), true));
    }
    discovery.ifPresent(asking -> asking.ask(each.topic()));
    publishers.forEach(this::found);
  }

  synchronized void remove(Wanted each) {
    List<Wanted> left = wanted.getOrDefault(each.topic(), new ArrayList<>());
    left.remove(each);
    if (left.isEmpty()) {
      wanted.remove(each.topic());
      loop.leave(() -> sockets.filter(each.topic(), false));
    }
    if (left.stream().noneMatch(other -> other.type().equals(each.type()))) {
      List<Announcement> served = connections.values().stream().flatMap(Set::stream)
          .filter(said -> said.topic().equals(each.topic()) && type(said).equals(each.type())).toList();
      served.forEach(said -> tell(Kind.END_CONNECTION, said));
      served.forEach(this::lost);
    }
  }

  /** Connects where somebody wants it, and says so each time it is announced: who was away has forgotten it. */
  synchronized void found(Announcement said) {
    boolean wants = PeerAddress.isGood(said.address())
        && wanted.getOrDefault(said.topic(), List.of()).stream().anyMatch(each -> each.type().equals(type(said)));
    if (wants) {
      if (connections.computeIfAbsent(said.address(), address -> new HashSet<>()).add(said)) {
        loop.leave(() -> sockets.hear(said.address()));
      }
      tell(Kind.NEW_CONNECTION, said);
    }
  }

  private void tell(Kind kind, Announcement said) {
    Announcement ours = new Announcement(said.topic(), said.address(), own.process(), own.node(), Scope.ALL,
        new Ends.Messages(said.process(), type(said)));
    discovery.ifPresent(telling -> telling.tell(kind, ours));
  }

  synchronized void lost(Announcement said) {
    Set<Announcement> there = connections.getOrDefault(said.address(), new HashSet<>());
    if (there.remove(said) && there.isEmpty()) {
      connections.remove(said.address());
      long until = System.nanoTime() + LAST_WORDS;
      loop.leave(() -> pending.send(() -> ignored(said.address(), until), until + LAST_WORDS));
    }
  }

  /** Who says that he ends may have published a moment before, and that may come later. */
  private synchronized boolean ignored(String address, long until) {
    boolean over = System.nanoTime() - until > 0;
    if (over && !connections.containsKey(address)) {
      sockets.ignore(address);
    }
    return over;
  }

  /** How many nodes publish what is wanted, and are connected to. */
  synchronized int publishers(Wanted each) {
    return (int) connections.values().stream().flatMap(Set::stream)
        .filter(said -> said.topic().equals(each.topic()) && type(said).equals(each.type())).count();
  }

  /** All that is received. */
  synchronized List<Announcement> subscriptions() {
    return wanted.values().stream().flatMap(List::stream).map(each -> new Announcement(each.topic(), "", own.process(),
        own.node(), Scope.ALL, new Ends.Messages("", each.type()))).distinct().toList();
  }

  /** Ends all of it. */
  synchronized void end() {
    wanted.values().stream().flatMap(List::stream).toList().forEach(this::remove);
  }

  /** Takes what has come, but no more than so many; answers whether there may be more. On the thread of the loop. */
  boolean take(ZMQ.Socket subscriber, int most) {
    for (int i = 0; i < most; i++) {
      Optional<Frames> frames = Frames.receive(subscriber);
      if (frames.isEmpty()) {
        return false;
      }
      frames.filter(all -> all.size() >= PARTS).ifPresent(this::arrived);
    }
    return true;
  }

  private synchronized void arrived(Frames all) {
    Received received = new Received(all.text(1), ByteBuffer.wrap(all.parts().get(2)), System.nanoTime());
    String type = all.text(3);
    wanted.getOrDefault(all.text(0), List.of()).stream().filter(each -> each.type().equals(type))
        .forEach(each -> each.source().arrived(received));
  }

  private static String type(Announcement said) {
    return said.ends() instanceof Ends.Messages messages ? messages.type() : "";
  }
}
