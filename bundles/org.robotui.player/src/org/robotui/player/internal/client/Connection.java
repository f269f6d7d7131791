package org.robotui.player.internal.client;

import java.io.Closeable;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicLong;
import org.robotui.net.call.Outcome;
import org.robotui.net.socket.DeadlineInput;
import org.robotui.net.socket.HostPort;
import org.robotui.net.socket.Sockets;
import org.robotui.player.client.ClientOptions;
import org.robotui.player.wire.DeviceAddress;
import org.robotui.player.wire.DeviceId;
import org.robotui.player.wire.Framing;
import org.robotui.player.wire.MessageType;
import org.robotui.player.wire.PlayerException;
import org.robotui.player.wire.PlayerMessage;

/** One connection to a server, from the greeting to its end. */
final class Connection implements Closeable {

  /** What takes the messages that are no answers. */
  interface Sink {

    void data(PlayerMessage message);

    void sync(PlayerMessage message);

    void unexpected(PlayerMessage message);
  }

  private static final int BUFFER = 1 << 16;
  private static final long NEVER = Duration.ofDays(1).toNanos();

  private final String peer;
  private final ClientOptions options;
  private final Socket socket;
  private final OutBox out;
  private final Requests requests;
  private final AtomicLong sequence = new AtomicLong();
  private final Optional<Fetcher> fetcher;
  private DeadlineInput in;
  private int host;
  private int robot;
  private String version = "";

  /** Of a socket that is not connected yet. */
  Connection(String peer, ClientOptions options) throws IOException {
    this.peer = peer;
    this.socket = options.sockets().createSocket();
    this.options = options;
    this.out = new OutBox(options.maxRequests());
    this.requests = new Requests(peer, options.maxRequests());
    this.fetcher = options.pull().map(period -> new Fetcher(period, options.answerTime()));
  }

  /** Reaches the server and reads its greeting. */
  void connect(HostPort server) throws IOException, PlayerException {
    InetSocketAddress address = server.resolve();
    Sockets.minimizeSendBuffer(socket);
    socket.connect(address, (int) Math.max(1, options.handshake().toMillis()));
    Sockets.prepare(socket);
    host = DeviceAddress.host(address.getAddress().getAddress());
    robot = address.getPort();
    in = new DeadlineInput(socket, BUFFER);
    in.within(options.handshake());
    version = Framing.readBanner(in);
  }

  String version() {
    return version;
  }

  /** The address of a device that the server did not list. */
  DeviceAddress address(DeviceId id) {
    return id.at(host, robot);
  }

  /** Asks the server itself and waits, before anything else runs on the connection. */
  PlayerMessage handshake(PlayerMessage question) throws IOException, PlayerException {
    PlayerMessage numbered = numbered(question);
    write(Framing.bytes(numbered));
    while (true) {
      PlayerMessage message = Framing.read(in);
      boolean isAnswer = message.type() == MessageType.ACK || message.type() == MessageType.NACK;
      if (isAnswer && message.device().id().equals(DeviceId.SERVER) && message.sequence() == numbered.sequence()) {
        return message;
      }
    }
  }

  /** Receives until the connection ends, which is always an exception. */
  void receive(Sink sink) throws IOException, PlayerException {
    while (true) {
      in.nextMessage(options.messageTime());
      PlayerMessage message = Framing.read(in);
      switch (message.type()) {
        case DATA -> sink.data(message);
        case ACK, NACK -> requests.answer(message);
        case SYNC -> {
          fetcher.ifPresent(each -> each.synced(message.subtype()));
          out.wake();
          sink.sync(message);
        }
        default -> sink.unexpected(message);
      }
    }
  }

  /** Sends what waits until the connection is closed or fails. */
  void send() throws IOException, InterruptedException {
    while (!out.isDone()) {
      long now = System.nanoTime();
      requests.expire(now);
      if (fetcher.filter(each -> each.isDue(now)).isPresent()) {
        write(
            Framing.bytes(numbered(PlayerMessage.empty(address(DeviceId.SERVER), MessageType.REQUEST, Fetcher.FETCH))));
      }
      long next = requests.nextDeadline(fetcher.map(each -> each.nextLook(now)).orElse(now + NEVER));
      Optional<ByteBuffer> frame = out.take(next);
      if (frame.isPresent()) {
        write(frame.get());
      }
    }
  }

  /** Asks a device; never waits. */
  CompletableFuture<Outcome<PlayerMessage>> request(PlayerMessage question, String name) {
    PlayerMessage numbered = numbered(question);
    CompletableFuture<Outcome<PlayerMessage>> answer = requests.add(numbered, name, options.answerTime());
    if (!answer.isDone() && !out.request(Framing.bytes(numbered))) {
      answer.complete(new Outcome.Failed<>(name + " at " + peer + ": too many requests wait for the network"));
    }
    return answer;
  }

  /** Commands a device; never waits. */
  boolean command(PlayerMessage command) {
    return out.command(new OutBox.Slot(command.device().id(), command.subtype()), Framing.bytes(numbered(command)));
  }

  long replaced() {
    return out.replaced();
  }

  /** Takes no more; what waits is still sent, then {@link #send} ends. */
  void finish() {
    out.finish();
  }

  /** Ends all requests; their reason names the peer. */
  void fail(String reason) {
    requests.fail(reason);
  }

  @Override
  public void close() {
    out.finish();
    Sockets.closeQuietly(socket);
  }

  private PlayerMessage numbered(PlayerMessage message) {
    return message.withSequence(sequence.incrementAndGet() & 0xffffffffL);
  }

  private void write(ByteBuffer frame) throws IOException {
    socket.getOutputStream().write(frame.array(), frame.arrayOffset() + frame.position(), frame.remaining());
  }
}
