package org.robotui.guard.internal.process;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.StandardSocketOptions;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.BooleanSupplier;
import org.robotui.guard.internal.wire.Wire;

/** All connections of a guard, on one thread. */
final class Relay implements Orders.Taker, AutoCloseable {
  private static final long LOOK_MILLIS = 50;
  private static final Duration TICK = Duration.ofMillis(25);
  private static final int MOST_GREETINGS = 64;
  private static final Duration LAST = Duration.ofSeconds(1);

  private final byte[] knock;
  private final byte[] answer;
  private final Limits limits;
  private final LineSender voice;
  private final BooleanSupplier guardedLives;
  private final Selector selector = Selector.open();
  private final ServerSocketChannel server = ServerSocketChannel.open();
  private final Queue<Runnable> tasks = new ConcurrentLinkedQueue<>();
  private final Map<Integer, Calls.Farewell> farewells = new LinkedHashMap<>();
  private final Chunks chunks;
  private final Calls calls;
  private final HeartbeatTimer silence = new HeartbeatTimer(System.nanoTime());
  private long lastTick = System.nanoTime();
  private boolean silent;
  private boolean over;
  private boolean goodbye;

  Relay(byte[] knock, byte[] answer, Limits limits, LineSender voice, BooleanSupplier guardedLives) throws IOException {
    this.knock = knock;
    this.answer = answer;
    this.limits = limits;
    this.voice = voice;
    this.guardedLives = guardedLives;
    this.chunks = new Chunks(limits.chunks());
    this.calls = new Calls(selector, limits);
    server.setOption(StandardSocketOptions.SO_RCVBUF, 1); // commands must not wait here
    server.bind(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0));
    server.configureBlocking(false);
    server.register(selector, SelectionKey.OP_ACCEPT);
  }

  int port() throws IOException {
    return ((InetSocketAddress) server.getLocalAddress()).getPort();
  }

  /** Until the guarded process is gone and all is said. */
  void run() throws IOException {
    while (!over) {
      turn();
      listen();
    }
    Channels.quietly(server);
    long end = System.nanoTime() + (goodbye ? LAST : limits.calls()).toNanos();
    if (!goodbye) {
      part();
    }
    while (System.nanoTime() < end && !(goodbye ? streams().isEmpty() : calls.areDone())) {
      turn();
    }
  }

  private void turn() throws IOException {
    selector.select(LOOK_MILLIS);
    for (Runnable task = tasks.poll(); task != null; task = tasks.poll()) {
      task.run();
    }
    for (SelectionKey key : selector.selectedKeys()) {
      handle(key);
    }
    selector.selectedKeys().clear();
    long now = System.nanoTime();
    if (now - lastTick > TICK.toNanos()) {
      lastTick = now;
      handlers().forEach(handler -> attempt(handler, () -> handler.tick(now)));
      calls.tick(now);
    }
  }

  private void handle(SelectionKey key) throws IOException {
    if (!key.isValid()) {
      return;
    }
    if (key.isAcceptable()) {
      accept();
    } else if (key.attachment() instanceof Handler handler) {
      attempt(handler, () -> handler.ready(key));
    }
  }

  /** What one connection may fail at. */
  @FunctionalInterface
  private interface Attempt {
    void run() throws IOException;
  }

  private static void attempt(Handler handler, Attempt attempt) {
    try {
      attempt.run();
    } catch (IOException | RuntimeException e) {
      handler.close();
    }
  }

  private List<Handler> handlers() {
    return selector.keys().stream().filter(SelectionKey::isValid).map(SelectionKey::attachment)
        .filter(Handler.class::isInstance).map(Handler.class::cast).distinct().toList();
  }

  private List<Stream> streams() {
    return handlers().stream().filter(Stream.class::isInstance).map(Stream.class::cast).toList();
  }

  private void accept() throws IOException {
    SocketChannel near = server.accept();
    if (near == null) {
      return;
    }
    List<Handler> greetings = handlers().stream().filter(ConnectionHandshake.class::isInstance).toList();
    if (greetings.size() >= MOST_GREETINGS) {
      greetings.getFirst().close();
    }
    near.configureBlocking(false);
    near.setOption(StandardSocketOptions.TCP_NODELAY, true);
    ConnectionHandshake.on(near.register(selector, SelectionKey.OP_READ), knock, answer, this::stream);
  }

  private Stream stream(SelectionKey near, SelectionKey far) {
    return new Stream(near, far, new Backlog(chunks, limits.chunksEach()), limits.full(),
        () -> silence.quiet() > limits.late().toNanos(),
        this::overflowed);
  }

  private void overflowed(Stream stream) {
    String where;
    try {
      where = stream.where();
    } catch (IOException e) {
      where = "a robot that is gone";
    }
    voice.say(Wire.OVERFLOW + where + " " + stream.waiting());
  }

  private void listen() {
    long quiet = silence.at(System.nanoTime());
    if (quiet == 0) {
      silent = false;
    } else if (quiet > limits.silent().toNanos()) {
      if (!silent) {
        silent = true;
        part();
      }
      over |= !guardedLives.getAsBoolean();
    }
  }

  /** Nobody at the robot shall wait for a process that is stopped or gone. */
  private void part() {
    List<Stream> open = streams();
    if (!over) {
      voice.say(Wire.SILENCE + open.size() + " connections closed, " + farewells.size() + " farewells said");
    }
    open.forEach(Stream::close);
    calls.say(farewells.values(), System.nanoTime());
  }

  private void order(Runnable task) {
    tasks.add(task);
    selector.wakeup();
  }

  @Override
  public void beat() {
    silence.beat();
    voice.say(Wire.ECHO);
  }

  @Override
  public void keep(int id, InetSocketAddress to, byte[] words) {
    order(() -> {
      long all = farewells.values().stream().mapToLong(farewell -> farewell.words().length).sum();
      if (farewells.size() < Wire.MOST_FAREWELLS && all + words.length <= Wire.ALL_WORDS) {
        farewells.put(id, new Calls.Farewell(to, words));
      }
    });
  }

  @Override
  public void withdraw(int id) {
    order(() -> farewells.remove(id));
  }

  @Override
  public void end(boolean saidGoodbye) {
    order(() -> {
      goodbye = saidGoodbye;
      over = true;
    });
  }

  @Override
  public void close() {
    handlers().forEach(Handler::close);
    Channels.quietly(server);
    Channels.quietly(selector);
  }
}
