package org.robotui.gazebo.internal;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.robotui.gazebo.internal.DiscoveryMessage.Announcement;
import org.robotui.gazebo.internal.DiscoveryMessage.Kind;
import org.robotui.gazebo.internal.DiscoveryMessage.Scope;
import org.robotui.net.log.PeerText;
import org.robotui.net.thread.Workers;

/**
 * Tells others what this process has and finds what they have, for topics or for services. Who says nothing for three
 * seconds has gone, and comes again when it is heard again. What it says may be said by any thread.
 */
final class Discovery implements AutoCloseable {
  private static final long BEAT = Duration.ofSeconds(1).toNanos();
  private static final long SILENCE = Duration.ofSeconds(3).toNanos();

  private final DiscoverySocket socket;
  private final String process;
  private final int version;
  private final DiscoveryEvents events;
  private final DiscoveryTable table = new DiscoveryTable();
  private final Set<Announcement> own = ConcurrentHashMap.newKeySet();
  private volatile List<String> processes = List.of();
  private long beaten;

  /** Listens from now on, on a thread of its own. */
  Discovery(DiscoverySocket socket, String process, int version, DiscoveryEvents events) {
    this.socket = socket;
    this.process = process;
    this.version = version;
    this.events = events;
    this.beaten = System.nanoTime() - BEAT;
  }

  void start(Workers workers, String name) {
    workers.start(name, this::run);
  }

  /** Processes that were heard lately. */
  List<String> processes() {
    return processes;
  }

  void advertise(Announcement announced) {
    own.add(announced);
    say(Kind.ADVERTISE, "", Optional.of(announced));
  }

  void unadvertise(Announcement announced) {
    if (own.remove(announced)) {
      say(Kind.UNADVERTISE, "", Optional.of(announced));
    }
  }

  /** Asks who has something. */
  void ask(String topic) {
    say(Kind.SUBSCRIBE, topic, Optional.empty());
  }

  /** Says that a node of ours has connected, or ends. */
  void tell(Kind kind, Announcement subject) {
    say(kind, "", Optional.of(subject));
  }

  private void say(Kind kind, String topic, Optional<Announcement> subject) {
    try {
      socket.send(DiscoveryWriter.write(new DiscoveryMessage(version, process, kind, topic, subject, false)));
    } catch (IOException e) {
      // the network takes nothing now: what matters is said again with the next beat
    }
  }

  private void run() {
    while (!socket.isClosed()) {
      try {
        Optional<DiscoverySocket.Datagram> datagram = socket.receive();
        datagram.ifPresent(this::read);
      } catch (IOException e) {
        if (!socket.isClosed()) {
          events.unreadable("discovery: " + e.getMessage());
        }
      }
      tick(System.nanoTime());
    }
  }

  private void read(DiscoverySocket.Datagram datagram) {
    try {
      DiscoveryMessage message = DiscoveryReader.read(datagram.bytes(), datagram.size());
      boolean concerns = message.version() == version && !message.process().equals(process)
          && !message.process().isEmpty() && !message.relayed();
      if (concerns) {
        heard(message, datagram.local());
      }
    } catch (IOException e) {
      events.unreadable("discovery: what came from " + datagram.from().getHostAddress() + " cannot be read: "
          + PeerText.brief(String.valueOf(e.getMessage())));
    }
  }

  private void heard(DiscoveryMessage message, boolean local) {
    boolean known = table.knows(message.process());
    if (message.kind() == Kind.BYE) {
      gone(message.process());
      return;
    }
    if (!table.hears(message.process(), System.nanoTime())) {
      return;
    }
    if (!known) {
      changed();
    }
    if (message.kind() == Kind.SUBSCRIBE) {
      own.stream().filter(each -> each.topic().equals(message.topic()) && isFor(each, local))
          .forEach(each -> say(Kind.ADVERTISE, "", Optional.of(each)));
    } else if (message.kind() == Kind.SUBSCRIBERS_REQUEST) {
      events.subscribersWanted();
    }
    message.subject().filter(said -> said.process().equals(message.process()) && isFor(said, local))
        .ifPresent(said -> subject(message.kind(), said));
  }

  private static boolean isFor(Announcement said, boolean local) {
    return said.scope() == Scope.ALL || said.scope() == Scope.HOST && local;
  }

  private void subject(Kind kind, Announcement said) {
    switch (kind) {
      case ADVERTISE -> {
        table.announce(said).forEach(events::lost);
        events.found(said);
      }
      case UNADVERTISE -> table.withdraw(said).forEach(events::lost);
      case NEW_CONNECTION, SUBSCRIBERS_REPLY -> {
        table.subscribe(said);
        events.connected(said);
      }
      case END_CONNECTION -> table.unsubscribe(said).forEach(events::disconnected);
      default -> {}
    }
  }

  private void tick(long now) {
    if (now - beaten >= BEAT) {
      beaten = now;
      say(Kind.HEARTBEAT, "", Optional.empty());
      new ArrayList<>(own).forEach(each -> say(Kind.ADVERTISE, "", Optional.of(each)));
    }
    table.silent(now, SILENCE).forEach(this::gone);
  }

  private void gone(String who) {
    if (table.knows(who)) {
      DiscoveryTable.Gone all = table.remove(who);
      all.announced().forEach(events::lost);
      all.subscriptions().forEach(events::disconnected);
      changed();
    }
  }

  private void changed() {
    processes = table.processes();
    events.processes();
  }

  /** Takes back what was announced, says goodbye and ends. */
  @Override
  public void close() {
    new ArrayList<>(own).forEach(this::unadvertise);
    say(Kind.BYE, "", Optional.empty());
    socket.close();
  }
}
