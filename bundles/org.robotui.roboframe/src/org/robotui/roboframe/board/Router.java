package org.robotui.roboframe.board;

import java.io.Closeable;
import java.io.IOException;
import java.net.Socket;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import org.robotui.message.MessageException;
import org.robotui.net.call.Backoff;
import org.robotui.net.log.LogThrottle;
import org.robotui.net.log.PeerText;
import org.robotui.net.socket.TcpListener;
import org.robotui.net.thread.Workers;
import org.robotui.roboframe.internal.BoardWatch;
import org.robotui.roboframe.internal.Outgoing;
import org.robotui.roboframe.internal.PeerBoard;
import org.robotui.roboframe.link.BrokerLink;
import org.robotui.roboframe.link.BrokerListener;
import org.robotui.roboframe.link.BrokerOptions;
import org.robotui.roboframe.wire.BoardKey;
import org.robotui.roboframe.wire.BrokerMessage;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Shares the keys of a blackboard with other applications: what a module there reads and one here writes goes there,
 * and the other way round. What came from one application does not go on to a third one. Links that end are made again.
 * Safe for all threads.
 */
public final class Router implements Closeable {

  private static final Logger LOG = LoggerFactory.getLogger(Router.class);
  private static final int MOST_PEERS = 64;
  private static final Duration FIRST_RETRY = Duration.ofMillis(100);
  private static final Duration LAST_RETRY = Duration.ofSeconds(2);
  private static final Duration PATIENCE = Duration.ofMillis(1500);
  private static final Duration END = Duration.ofSeconds(2);
  private static final long LOOK_MILLIS = 50;
  private static final long GIVEN_UP_NANOS = Duration.ofSeconds(10).toNanos();

  private final Blackboard blackboard;
  private final BrokerOptions options;
  private final Workers workers;
  private final List<TcpListener> listeners = new ArrayList<>();
  private final Map<BrokerLink, PeerBoard> peers = new ConcurrentHashMap<>();
  private final CountDownLatch closed = new CountDownLatch(1);
  private final AtomicLong unreadable = new AtomicLong();
  private final LogThrottle troubles = new LogThrottle();
  private final BoardWatch watch = new Watch();

  /**
   * Listens and connects at once.
   *
   * @param blackboard whose keys are shared
   * @param application what it is called
   * @param connectors how it comes to others
   * @param threads makes its threads
   * @throws IOException where it cannot listen; names the port
   */
  public Router(Blackboard blackboard, String application, List<Connector> connectors, ThreadFactory threads)
      throws IOException {
    this.blackboard = blackboard;
    this.options = new BrokerOptions(application, threads, PATIENCE, false);
    this.workers = new Workers(threads);
    try {
      for (Connector each : connectors) {
        begin(each);
      }
    } catch (IOException e) {
      close();
      throw e;
    }
    blackboard.watch(watch);
    workers.start("roboframe router", this::look);
  }

  private void begin(Connector connector) throws IOException {
    switch (connector) {
      case Connector.Listen listen -> {
        TcpListener listener = TcpListener.bind(listen.address(), listen.port());
        listeners.add(listener);
        workers.start("roboframe listener", () -> listener.acceptAll("roboframe", this::accept));
      }
      case Connector.Connect connect -> workers.start("roboframe to " + connect.address(), () -> connect(connect));
    }
  }

  /**
   * Where it listens.
   *
   * @return ports, in the order of the connectors
   */
  public List<Integer> ports() {
    return listeners.stream().map(TcpListener::port).toList();
  }

  /**
   * The applications that are linked.
   *
   * @return their names, sorted
   */
  public List<String> applications() {
    return peers.keySet().stream().flatMap(link -> link.application().stream()).sorted().toList();
  }

  /**
   * The keys that other applications use.
   *
   * @return one for each application that uses it
   */
  public List<BoardKey> remoteKeys() {
    return peers.values().stream().flatMap(peer -> peer.keys().stream()).toList();
  }

  /**
   * Values that came and could not be read.
   *
   * @return how many so far
   */
  public long unreadable() {
    return unreadable.get();
  }

  private void accept(Socket socket) throws IOException {
    if (peers.size() >= MOST_PEERS) {
      throw new IOException("there are " + MOST_PEERS + " applications already");
    }
    took(BrokerLink.begin(socket, String.valueOf(socket.getRemoteSocketAddress()), options, new FromPeer()));
  }

  /** It may have ended before it was noted. */
  private void took(BrokerLink link) {
    PeerBoard peer = peers.computeIfAbsent(link, PeerBoard::new);
    peer.own(blackboard::keys).forEach(key -> share(peer, key));
    if (link.over().isPresent() || isClosed()) {
      peers.remove(link, peer);
      link.cut();
    }
  }

  private boolean isClosed() {
    return closed.getCount() == 0;
  }

  private void connect(Connector.Connect connector) {
    Backoff pauses = new Backoff(FIRST_RETRY, LAST_RETRY);
    while (!isClosed()) {
      try {
        BrokerLink link = BrokerLink.connect(connector.address(), options, new FromPeer());
        pauses.reset();
        took(link);
        while (peers.containsKey(link) && !closed.await(LOOK_MILLIS, TimeUnit.MILLISECONDS)) {
          // the link goes on
        }
        closed.await(pauses.next().toMillis(), TimeUnit.MILLISECONDS);
      } catch (IOException e) {
        trouble(String.valueOf(e.getMessage()));
        pause(pauses.next());
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        return;
      }
    }
  }

  private void pause(Duration pause) {
    try {
      closed.await(pause.toMillis(), TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void trouble(String reason) {
    if (troubles.admit()) {
      LOG.warn("roboframe: {} ({} such so far)", reason, troubles.count());
    }
  }

  /** Asks all others whether they are there, and gives up those that say nothing, or not who they are. */
  private void look() {
    try {
      while (!closed.await(LOOK_MILLIS, TimeUnit.MILLISECONDS)) {
        for (BrokerLink link : peers.keySet()) {
          link.beat();
          boolean late = link.application().isEmpty() && link.silentNanos() > options.patience().toNanos();
          if (late || link.silentNanos() > GIVEN_UP_NANOS) {
            trouble(link.peer() + " says nothing");
            link.cut();
          }
        }
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private final class FromPeer implements BrokerListener {
    @Override
    public void board(BrokerLink link, List<BoardKey> keys) {
      PeerBoard peer = peers.computeIfAbsent(link, PeerBoard::new);
      peer.theirs(keys).forEach(key -> share(peer, key));
    }

    @Override
    public void value(BrokerLink link, BrokerMessage.Value value) {
      try {
        blackboard.came(value, link.application().orElse(link.peer()));
      } catch (MessageException | IllegalArgumentException e) {
        unreadable.incrementAndGet();
        trouble(link.peer() + ": a value of " + PeerText.brief(value.key()) + " cannot be read: "
            + PeerText.brief(String.valueOf(e.getMessage())));
      }
    }

    @Override
    public void ended(BrokerLink link, String reason) {
      peers.remove(link);
    }
  }

  /** What stands at a key that another application begins to read. */
  private void share(PeerBoard peer, String key) {
    blackboard.own(key).ifPresent(peer::tell);
  }

  private final class Watch implements BoardWatch {
    @Override
    public void changed() {
      peers.values().forEach(peer -> peer.own(blackboard::keys).forEach(key -> share(peer, key)));
    }

    @Override
    public int readers(String key) {
      return (int) peers.values().stream().filter(peer -> peer.reads(key)).count();
    }

    @Override
    public void posted(Outgoing value) {
      peers.values().forEach(peer -> peer.tell(value));
    }
  }

  /** Says what waits where others take it within a moment, and ends; bounded. */
  @Override
  public void close() {
    closed.countDown();
    blackboard.unwatch(watch);
    listeners.forEach(TcpListener::close);
    peers.keySet().forEach(BrokerLink::close);
    workers.join(System.nanoTime() + END.toNanos());
  }
}
