package org.robotui.roboframe.link;

import java.io.Closeable;
import java.io.IOException;
import java.net.Socket;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.robotui.net.link.FrameLink;
import org.robotui.net.socket.HostPort;
import org.robotui.net.socket.Sockets;
import org.robotui.net.thread.Workers;
import org.robotui.roboframe.wire.BoardKey;
import org.robotui.roboframe.wire.BrokerFraming;
import org.robotui.roboframe.wire.BrokerMessage;

/**
 * A connection to the broker of another application. Saying something never blocks: of each key only the newest value
 * waits for a peer that reads slowly, unless every one counts, and then the number of those that wait is bounded. Safe
 * for all threads.
 */
public final class BrokerLink implements Closeable {

  private static final Duration END = Duration.ofMillis(500);
  private static final long BEAT_NANOS = Duration.ofMillis(100).toNanos();
  private static final String BOARD = " board";
  private static final String PONG = " pong";

  private final String peer;
  private final BrokerListener listener;
  private final Workers workers;
  private final Socket socket;
  private final FrameLink<BrokerMessage> link;
  private final CompletableFuture<String> greeted = new CompletableFuture<>();
  private volatile Optional<String> over = Optional.empty();
  private volatile long heardAt = System.nanoTime();
  private volatile long beatAt = heardAt - BEAT_NANOS;

  private BrokerLink(Socket socket, String peer, BrokerOptions options, BrokerListener listener) throws IOException {
    this.peer = peer;
    this.listener = listener;
    this.socket = socket;
    this.workers = new Workers(options.threads());
    this.link = new FrameLink<>(socket, new BrokerFraming(), new FromPeer());
  }

  /**
   * Connects and waits until the other side has said who it is; blocks.
   *
   * @param address of the other application
   * @param options how
   * @param listener takes what it says, also before this returns
   * @return a link that has begun
   * @throws IOException where there is no such application; names the address
   */
  public static BrokerLink connect(HostPort address, BrokerOptions options, BrokerListener listener)
      throws IOException {
    Socket socket = new Socket();
    try {
      if (options.prompt()) {
        Sockets.minimizeSendBuffer(socket);
      }
      address.connect(socket, options.patience());
      BrokerLink made = begin(socket, address.toString(), options, listener);
      made.await(options.patience());
      return made;
    } catch (IOException | RuntimeException e) {
      Sockets.closeQuietly(socket);
      throw e;
    }
  }

  /**
   * Begins with a connection, without waiting for the other side.
   *
   * @param socket is closed with the link
   * @param peer what the other side is called in errors
   * @param options how
   * @param listener takes what it says
   * @return a link; {@link #application} says whether it has begun
   * @throws IOException where the connection ended already
   */
  public static BrokerLink begin(Socket socket, String peer, BrokerOptions options, BrokerListener listener)
      throws IOException {
    Sockets.prepare(socket);
    BrokerLink made = new BrokerLink(socket, peer, options, listener);
    // before any value can be said, which would overtake what waits; a new connection always takes so little
    socket.getOutputStream().write(new BrokerFraming()
        .bytes(new BrokerMessage.Hello(BrokerFraming.VERSION, options.application())));
    made.link.start(made.workers, "roboframe " + peer);
    return made;
  }

  private void await(Duration patience) throws IOException {
    try {
      greeted.get(patience.toNanos(), TimeUnit.NANOSECONDS);
    } catch (TimeoutException e) {
      throw failed("it did not say in time who it is", e);
    } catch (ExecutionException e) {
      throw failed(e.getCause().getMessage(), e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw failed("connecting was given up", e);
    }
  }

  private IOException failed(String reason, Exception cause) {
    link.finish();
    return new IOException(peer + ": " + reason, cause);
  }

  private final class FromPeer implements FrameLink.Receiver<BrokerMessage> {
    @Override
    public void received(BrokerMessage message, FrameLink<BrokerMessage> from) throws IOException {
      heardAt = System.nanoTime();
      if (!greeted.isDone() && !(message instanceof BrokerMessage.Hello)) {
        throw new IOException("it did not say first who it is");
      }
      switch (message) {
        case BrokerMessage.Hello hello -> {
          if (!greeted.complete(hello.application())) {
            throw new IOException("it said twice who it is");
          }
        }
        case BrokerMessage.Board board -> listener.board(BrokerLink.this, board.keys());
        case BrokerMessage.Value value -> listener.value(BrokerLink.this, value);
        case BrokerMessage.Ping ping -> link.replace(PONG, new BrokerMessage.Pong(ping.token()));
        case BrokerMessage.Pong pong -> {} // it is there, which was noted
      }
    }

    @Override
    public void ended(FrameLink<BrokerMessage> from, String reason) {
      over = Optional.of(peer + ": " + reason);
      greeted.completeExceptionally(new IOException(reason));
      listener.ended(BrokerLink.this, reason);
    }
  }

  /**
   * What the other application is called.
   *
   * @return none until it has said so
   */
  public Optional<String> application() {
    return greeted.isDone() && !greeted.isCompletedExceptionally() ? Optional.of(greeted.join()) : Optional.empty();
  }

  /**
   * Says which keys we use, in place of what we said before.
   *
   * @param keys all of them
   */
  public void say(List<BoardKey> keys) {
    link.replace(BOARD, new BrokerMessage.Board(keys));
  }

  /**
   * Says a value in place of an older one of its key that still waits.
   *
   * @param value of a key that the other side reads
   * @return false where the link has ended
   */
  public boolean push(BrokerMessage.Value value) {
    return link.replace(value.key(), value);
  }

  /**
   * Says a value in its turn.
   *
   * @param value of a key that the other side reads
   * @return false where the link has ended, or too many wait
   */
  public boolean queue(BrokerMessage.Value value) {
    return link.send(value);
  }

  /** Asks whether the other side is there, at most ten times a second. To be called again and again by one thread. */
  public void beat() {
    long now = System.nanoTime();
    if (now - beatAt >= BEAT_NANOS) {
      beatAt = now;
      link.replace(" ping", new BrokerMessage.Ping(now));
    }
  }

  /**
   * How long the other side has said nothing.
   *
   * @return nanoseconds
   */
  public long silentNanos() {
    return System.nanoTime() - heardAt;
  }

  /**
   * Why it has ended.
   *
   * @return empty while it has not
   */
  public Optional<String> over() {
    return over;
  }

  /**
   * What the other side is called in errors.
   *
   * @return mostly its address
   */
  public String peer() {
    return peer;
  }

  /** Ends it at once, and drops what waits; does not block. */
  public void cut() {
    link.finish();
    Sockets.closeQuietly(socket);
  }

  /** Says what waits where the other side takes it within a moment, and ends; bounded. */
  @Override
  public void close() {
    link.close();
    workers.join(System.nanoTime() + END.toNanos());
  }
}
