package org.robotui.yarp.port;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import org.robotui.net.log.PeerText;
import org.robotui.net.socket.DeadlineInput;
import org.robotui.net.socket.HostPort;
import org.robotui.net.socket.Sockets;
import org.robotui.net.thread.Workers;
import org.robotui.yarp.internal.DatagramOutput;
import org.robotui.yarp.internal.Dialing;
import org.robotui.yarp.wire.YarpCarrier;
import org.robotui.yarp.wire.YarpFraming;
import org.robotui.yarp.wire.YarpMessage;

/**
 * A connection to a port that is told something. It connects and writes on a thread of its own; telling never blocks.
 * What waits is replaced by newer of its kind, and what waits too long is dropped. By tcp one message is under way at a
 * time. It has one life: where it ends, that is said once.
 */
public final class PortStream implements AutoCloseable {
  private static final int BUFFER = 64;
  private static final long FLUSH_MILLIS = 400;

  private record Waiting(YarpMessage message, long until) {}

  private final HostPort where;
  private final YarpFraming.Header header;
  private final Optional<InetSocketAddress> group;
  private final PortOptions options;
  private final Map<String, Waiting> waiting = new LinkedHashMap<>(); // guarded by this, as the following
  private boolean finishing;
  private Optional<Socket> socket = Optional.empty();
  private final CountDownLatch flushed = new CountDownLatch(1);
  private final AtomicReference<Optional<String>> over = new AtomicReference<>(Optional.empty());

  /**
   * Begins to connect, by any carrier but mcast.
   *
   * @param where the port listens
   * @param carrier by which
   * @param name of who tells
   * @param options of connections
   * @param workers run its thread
   */
  public PortStream(HostPort where, YarpCarrier carrier, String name, PortOptions options, Workers workers) {
    this(where, carrier, Optional.empty(), name, options, workers);
  }

  /**
   * Begins to connect.
   *
   * @param where the port listens
   * @param carrier by which
   * @param group where datagrams are sent that several ports receive; for mcast only
   * @param name of who tells
   * @param options of connections
   * @param workers run its thread
   */
  public PortStream(HostPort where, YarpCarrier carrier, Optional<InetSocketAddress> group, String name,
      PortOptions options, Workers workers) {
    this.where = where;
    this.group = group;
    this.header = new YarpFraming.Header(carrier, name);
    this.options = options;
    workers.start("yarp to " + where, this::run);
  }

  private void run() {
    try {
      Socket connected = Dialing.connect(options.sockets(), where, options.patience());
      synchronized (this) {
        socket = Optional.of(connected);
      }
      talk(connected);
    } catch (IOException e) {
      end(PeerText.brief(String.valueOf(e.getMessage())));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      end("it was closed");
      flushed.countDown();
    }
  }

  private void talk(Socket connected) throws IOException, InterruptedException {
    DeadlineInput in = new DeadlineInput(connected, BUFFER);
    in.within(options.patience());
    connected.getOutputStream().write(YarpFraming.bytes(header));
    if (header.carrier().datagrams()) {
      datagrams(connected, in);
      return;
    }
    YarpFraming.readMark(in);
    for (Optional<YarpMessage> next = take(); next.isPresent(); next = take()) {
      in.within(options.patience());
      connected.getOutputStream().write(YarpFraming.bytes(next.get()));
      if (header.carrier().acknowledges()) {
        YarpFraming.readMark(in);
      }
    }
    connected.getOutputStream().write(YarpFraming.bytes(YarpMessage.quit()));
  }

  /** The connection is of no use any more. The end is said apart from it, as no datagram tells it for certain. */
  private void datagrams(Socket connected, DeadlineInput in) throws IOException, InterruptedException {
    try (DatagramOutput output = DatagramOutput.open(connected, in, group)) {
      Sockets.closeQuietly(connected);
      for (Optional<YarpMessage> next = take(); next.isPresent(); next = take()) {
        output.send(next.get());
      }
    }
    new PortAdmin(options).disconnect(where, header.name());
  }

  private synchronized Optional<YarpMessage> take() throws InterruptedException {
    while (true) {
      while (waiting.isEmpty() && !finishing) {
        wait();
      }
      if (waiting.isEmpty()) {
        return Optional.empty();
      }
      Waiting next = waiting.remove(waiting.keySet().iterator().next());
      if (next.until() == 0 || next.until() - System.nanoTime() > 0) {
        return Optional.of(next.message());
      }
    }
  }

  /**
   * Tells something in place of an older message of its kind that still waits.
   *
   * @param kind what it replaces
   * @param message what is told
   * @param lasts how long it may wait; zero for as long as it takes
   * @return false where the connection has ended
   */
  public synchronized boolean post(String kind, YarpMessage message, Duration lasts) {
    if (finishing) {
      return false;
    }
    waiting.remove(kind);
    waiting.put(kind, new Waiting(message, lasts.isZero() ? 0 : System.nanoTime() + lasts.toNanos()));
    notifyAll();
    return true;
  }

  /**
   * Why it has ended.
   *
   * @return empty while it connects and is connected
   */
  public Optional<String> over() {
    return over.get();
  }

  private void end(String reason) {
    Optional<Socket> open;
    synchronized (this) {
      finishing = true;
      waiting.clear();
      open = socket;
      notifyAll();
    }
    over.compareAndSet(Optional.empty(), Optional.of(reason));
    open.ifPresent(Sockets::closeQuietly);
  }

  /** Tells what waits, where the port takes it within a moment, and ends. */
  @Override
  public void close() {
    synchronized (this) {
      finishing = true;
      notifyAll();
    }
    try {
      flushed.await(FLUSH_MILLIS, TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    end("it was closed");
  }
}
