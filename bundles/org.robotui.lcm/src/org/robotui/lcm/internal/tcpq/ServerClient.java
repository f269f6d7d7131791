package org.robotui.lcm.internal.tcpq;

import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.net.Socket;
import java.net.SocketException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.robotui.lcm.tcpq.TcpqServerOptions;
import org.robotui.net.socket.DeadlineInput;
import org.robotui.net.socket.Sockets;

/** One client of a server: a thread reads its frames, another one writes what it subscribed to. */
final class ServerClient {

  private static final int BUFFER = 1 << 16;
  private static final int MOST_PATTERNS = 1000;

  private final Socket socket;
  private final TcpqServerOptions options;
  private final ServerRuntime server;
  private final List<ChannelPattern> patterns = new CopyOnWriteArrayList<>();
  private final Deque<ByteBuffer> queue = new ArrayDeque<>();
  private long queuedBytes;
  private boolean closed;
  private volatile boolean greeted;

  ServerClient(Socket socket, TcpqServerOptions options, ServerRuntime server) {
    this.socket = socket;
    this.options = options;
    this.server = server;
  }

  boolean isGreeted() {
    return greeted;
  }

  /** The work of the thread that reads. */
  void read() {
    try {
      DeadlineInput timed = new DeadlineInput(socket, BUFFER);
      DataInputStream in = new DataInputStream(timed);
      Sockets.prepare(socket);
      timed.within(options.greetingTime());
      Frames.expectGreeting(in, Frames.CLIENT);
      timed.withoutDeadline();
      enqueue(Frames.greeting(Frames.SERVER));
      server.start("LCM client's queue " + socket.getRemoteSocketAddress(), this::write);
      greeted = true;
      while (true) {
        obey(Frames.read(in, options.maxMessageBytes()));
      }
    } catch (EOFException | SocketException e) {
      // it went away, as clients do
    } catch (IOException | IllegalArgumentException | OutOfMemoryError e) {
      server.refused(socket, String.valueOf(e.getMessage()));
    } finally {
      close();
    }
  }

  private void obey(Frames.Frame frame) throws IOException {
    switch (frame) {
      case Frames.Message message -> server.route(message);
      case Frames.Subscribe subscribe -> {
        if (patterns.size() >= MOST_PATTERNS) {
          throw new IOException("more than " + MOST_PATTERNS + " subscriptions");
        }
        patterns.add(ChannelPattern.of(subscribe.channels()));
      }
      case Frames.Unsubscribe unsubscribe -> patterns.stream()
          .filter(each -> each.text().equals(unsubscribe.channels())).findFirst().ifPresent(patterns::remove);
    }
  }

  /** Queues a message if this client wants it. */
  void offer(Frames.Message message) {
    if (greeted && patterns.stream().anyMatch(pattern -> pattern.matches(message.channel()))) {
      enqueue(Frames.message(message.channel().getBytes(StandardCharsets.UTF_8), ByteBuffer.wrap(message.data())));
    }
  }

  private void enqueue(ByteBuffer frame) {
    synchronized (queue) {
      queue.addLast(frame);
      queuedBytes += frame.limit();
      while (queue.size() > 1 && queuedBytes > options.queueBytes()) {
        queuedBytes -= queue.removeFirst().limit();
        server.countDropped();
      }
      queue.notifyAll();
    }
  }

  private void write() {
    try {
      for (Optional<ByteBuffer> next = take(); next.isPresent(); next = take()) {
        socket.getOutputStream().write(next.get().array(), 0, next.get().limit());
      }
    } catch (IOException e) {
      close();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private Optional<ByteBuffer> take() throws InterruptedException {
    synchronized (queue) {
      while (queue.isEmpty() && !closed) {
        queue.wait();
      }
      Optional<ByteBuffer> frame = closed ? Optional.empty() : Optional.of(queue.removeFirst());
      frame.ifPresent(taken -> queuedBytes -= taken.limit());
      return frame;
    }
  }

  void close() {
    synchronized (queue) {
      closed = true;
      queue.clear();
      queue.notifyAll();
    }
    server.ended(this);
    Sockets.closeQuietly(socket);
  }
}
