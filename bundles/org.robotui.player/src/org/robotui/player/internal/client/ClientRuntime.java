package org.robotui.player.internal.client;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.LongAdder;
import org.robotui.net.call.Backoff;
import org.robotui.net.call.Outcome;
import org.robotui.net.log.LogThrottle;
import org.robotui.net.socket.HostPort;
import org.robotui.net.thread.Workers;
import org.robotui.player.client.ClientOptions;
import org.robotui.player.client.LinkState;
import org.robotui.player.layout.Layouts;
import org.robotui.player.wire.DeviceAddress;
import org.robotui.player.wire.DeviceId;
import org.robotui.player.wire.PlayerException;
import org.robotui.player.wire.PlayerMessage;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Keeps the link to one server: connects, receives, and begins anew when the link is lost. */
public final class ClientRuntime {

  private static final Logger LOG = LoggerFactory.getLogger(ClientRuntime.class);
  /** For what waits to be sent when the client is closed, such as a stop. */
  private static final Duration LAST_WORDS = Duration.ofMillis(250);
  private static final Duration END = Duration.ofSeconds(2);

  private final HostPort server;
  private final Layouts layouts;
  private final ClientOptions options;
  private final Workers workers;
  private final Map<DeviceId, DeviceLink> devices = new ConcurrentHashMap<>();
  private final CountDownLatch closing = new CountDownLatch(1);
  private final LongAdder overflows = new LongAdder();
  private final LongAdder unexpected = new LongAdder();
  private final LogThrottle failures = new LogThrottle();
  private volatile Optional<Connection> current = Optional.empty();
  private volatile Optional<Connection> attempt = Optional.empty();
  private volatile List<DeviceAddress> listed = List.of();
  private volatile LinkState state = new LinkState.Connecting();

  /** Begins to connect at once. */
  public ClientRuntime(String host, int port, Layouts layouts, ClientOptions options) {
    this.server = new HostPort(host, port);
    this.layouts = layouts;
    this.options = options;
    this.workers = new Workers(options.threads());
    workers.start("player " + peer(), this::run);
  }

  /** The server as people write it. */
  public String peer() {
    return server.toString();
  }

  public Layouts layouts() {
    return layouts;
  }

  public LinkState state() {
    return state;
  }

  public List<DeviceAddress> listed() {
    return listed;
  }

  public long overflows() {
    return overflows.sum();
  }

  public long unexpected() {
    return unexpected.sum();
  }

  public long replaced() {
    return current.map(Connection::replaced).orElse(0L);
  }

  /** The device, made when it is first asked for. */
  public DeviceLink device(DeviceId id) {
    return devices.computeIfAbsent(id, each -> new DeviceLink(each, this));
  }

  /** A device's address as the server writes it. */
  Optional<DeviceAddress> address(DeviceId id) {
    return current.map(connection -> listed.stream().filter(each -> each.id().equals(id)).findFirst()
        .orElseGet(() -> connection.address(id)));
  }

  Optional<Connection> current() {
    return current;
  }

  /** Asks; never waits. */
  CompletableFuture<Outcome<PlayerMessage>> request(PlayerMessage question, String name) {
    return current.map(connection -> connection.request(question, name))
        .orElseGet(
            () -> CompletableFuture.completedFuture(new Outcome.Failed<>(name + ": there is no link to " + peer())));
  }

  private void run() {
    Backoff backoff = new Backoff(options.minBackoff(), options.maxBackoff());
    while (!isClosing()) {
      announce(new LinkState.Connecting());
      pause(peer() + ": " + attempt(backoff), backoff);
    }
    String reason = "the client of " + peer() + " was closed";
    devices.values().forEach(device -> device.lost(reason));
    announce(new LinkState.Closed());
  }

  /** Makes one connection and runs it; answers why it ended. */
  private String attempt(Backoff backoff) {
    try {
      Connection connection = new Connection(peer(), options);
      attempt = Optional.of(connection);
      String reason = serve(connection, backoff);
      current = Optional.empty();
      connection.close();
      connection.fail(peer() + ": " + reason);
      return reason;
    } catch (IOException e) {
      return "no socket: " + e.getMessage();
    }
  }

  private String serve(Connection connection, Backoff backoff) {
    try {
      if (isClosing()) {
        return "closed";
      }
      connection.connect(server);
      listed = new Handshake(layouts, options).shake(connection);
      begin(connection);
      backoff.reset();
      announce(new LinkState.Connected(connection.version()));
      connection.receive(new Dispatch());
      return "the link ended";
    } catch (PlayerException | IOException e) {
      return Optional.ofNullable(e.getMessage()).orElseGet(() -> e.getClass().getSimpleName());
    }
  }

  private void begin(Connection connection) {
    workers.start("player to " + peer(), () -> send(connection));
    current = Optional.of(connection);
    if (isClosing()) {
      connection.finish();
    }
    devices.values().forEach(DeviceLink::openAgain);
  }

  private static void send(Connection connection) {
    try (connection) {
      connection.send();
    } catch (IOException e) {
      LOG.debug("sending ended: {}", e.getMessage());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void pause(String reason, Backoff backoff) {
    if (isClosing()) {
      return;
    }
    Duration wait = backoff.next();
    if (failures.admit()) {
      LOG.info("{} ({} failures so far)", reason, failures.count());
    }
    devices.values().forEach(device -> device.lost(reason));
    announce(new LinkState.Failed(reason, wait));
    try {
      closing.await(wait.toNanos(), TimeUnit.NANOSECONDS);
    } catch (InterruptedException e) {
      closing.countDown();
    }
  }

  private void announce(LinkState next) {
    state = next;
    try {
      options.links().onLink(next);
    } catch (RuntimeException e) {
      LOG.error("{}: a listener failed", peer(), e);
    }
  }

  private boolean isClosing() {
    return closing.getCount() == 0;
  }

  /** Ends everything in bounded time; what was commanded before is sent if the network takes it at once. */
  public void close() {
    closing.countDown();
    current.ifPresentOrElse(Connection::finish, () -> attempt.ifPresent(Connection::close));
    if (!workers.join(System.nanoTime() + LAST_WORDS.toNanos())) {
      attempt.ifPresent(Connection::close);
      workers.join(System.nanoTime() + END.toNanos());
    }
  }

  /** Hands data to their devices. */
  private final class Dispatch implements Connection.Sink {

    private static final int OVERFLOW = 2;

    @Override
    public void data(PlayerMessage message) {
      long now = System.nanoTime();
      Optional.ofNullable(devices.get(message.device().id())).ifPresentOrElse(device -> device.data(message, now),
          unexpected::increment);
    }

    @Override
    public void sync(PlayerMessage message) {
      if (message.subtype() == OVERFLOW && message.payload().remaining() >= Integer.BYTES) {
        overflows.add(Integer.toUnsignedLong(message.payload().getInt()));
      }
    }

    @Override
    public void unexpected(PlayerMessage message) {
      unexpected.increment();
    }
  }
}
