package org.robotui.roblets.internal;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetSocketAddress;
import java.net.PortUnreachableException;
import java.net.SocketTimeoutException;
import java.time.Duration;
import java.util.Arrays;
import java.util.Optional;
import java.util.concurrent.ThreadFactory;
import org.robotui.net.log.LogThrottle;
import org.robotui.net.thread.Workers;
import org.robotui.roblets.tree.BodyElement;
import org.robotui.roblets.tree.BodyXml;
import org.robotui.roblets.tree.BodyXmlException;
import org.robotui.roblets.wire.BodyDatagram;
import org.robotui.roblets.wire.DatagramKind;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** A socket for datagrams, and the thread that reads them. */
public final class DatagramEndpoint implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(DatagramEndpoint.class);
  private static final int IDLE_MILLIS = 50;
  private static final int BUFFER = 1 << 20;
  private static final Duration ENDING = Duration.ofSeconds(1);

  private final DatagramSocket socket;
  private final Workers workers;
  private final BodyXml xml = new BodyXml();
  private final LogThrottle throttle = new LogThrottle();
  private final String name;

  /** Hears of what comes, on the reading thread. */
  public interface Handler {
    /** A datagram that can be read. */
    void arrived(BodyDatagram datagram, byte[] bytes, InetSocketAddress from, long nowNanos);

    /** One that cannot. */
    default void unreadable(String reason, InetSocketAddress from) {}

    /** Nobody listens where something was sent; only told where the socket is connected. */
    default void unreachable() {}

    /** Called twenty times a second at least. */
    default void idle(long nowNanos) {}
  }

  private DatagramEndpoint(DatagramSocket socket, String name, ThreadFactory threads) {
    this.socket = socket;
    this.name = name;
    this.workers = new Workers(threads);
  }

  /** Bound to an address; where its port is 0, to a free one. */
  public static DatagramEndpoint bound(InetSocketAddress own, String name, ThreadFactory threads) throws IOException {
    DatagramSocket socket = new DatagramSocket(null);
    try {
      socket.setReceiveBufferSize(BUFFER);
      socket.setSoTimeout(IDLE_MILLIS);
      socket.bind(own);
      return new DatagramEndpoint(socket, name, threads);
    } catch (IOException | RuntimeException e) {
      socket.close();
      throw e;
    }
  }

  /** Takes and sends nothing but from and to one peer. */
  public void connect(InetSocketAddress peer) throws IOException {
    socket.connect(peer);
  }

  public int port() {
    return socket.getLocalPort();
  }

  /** Begins to read. */
  public void open(Handler handler) {
    workers.start(name, () -> read(handler));
  }

  private void read(Handler handler) {
    DatagramPacket packet = new DatagramPacket(new byte[BodyXml.MOST_BYTES + 1], BodyXml.MOST_BYTES + 1);
    while (!socket.isClosed()) {
      idle(handler);
      try {
        packet.setLength(BodyXml.MOST_BYTES + 1);
        socket.receive(packet);
        take(packet, handler);
      } catch (SocketTimeoutException e) {
        // nothing came
      } catch (PortUnreachableException e) {
        handler.unreachable();
      } catch (IOException e) {
        if (!socket.isClosed() && throttle.admit()) {
          LOG.warn("{}: a datagram was not received: {}", name, e.getMessage());
        }
      }
    }
  }

  private void idle(Handler handler) {
    try {
      handler.idle(System.nanoTime());
    } catch (RuntimeException e) {
      if (throttle.admit()) {
        LOG.error("{}: something that is due could not be done", name, e);
      }
    }
  }

  private void take(DatagramPacket packet, Handler handler) {
    byte[] bytes = Arrays.copyOfRange(packet.getData(), packet.getOffset(), packet.getOffset() + packet.getLength());
    InetSocketAddress from = (InetSocketAddress) packet.getSocketAddress();
    try {
      handler.arrived(BodyDatagram.of(bytes, xml), bytes, from, System.nanoTime());
    } catch (BodyXmlException e) {
      unreadable(handler, e.getMessage(), from);
    } catch (IllegalArgumentException e) {
      unreadable(handler, "a datagram that says what cannot be: " + e.getMessage(), from);
    } catch (RuntimeException e) {
      // whoever handles it has an error of its own; the endpoint stays open for all others
      LOG.error("{}: a datagram of {} could not be handled", name, from, e);
    }
  }

  private void unreadable(Handler handler, String reason, InetSocketAddress from) {
    if (throttle.admit()) {
      LOG.warn("{}: from {} came {} ({} so far)", name, from, reason, throttle.count());
    }
    handler.unreadable(from + ": " + reason, from);
  }

  /** Whether it was given to the network. What is counted first is sent first. */
  public boolean say(SenderRun sender, DatagramKind kind, String to, Optional<BodyElement> body,
      InetSocketAddress there) {
    synchronized (sender) {
      return send(sender.next(kind, to, body).bytes(), there);
    }
  }

  /** Whether it was given to the network. */
  public boolean send(byte[] bytes, InetSocketAddress to) {
    try {
      socket.send(new DatagramPacket(bytes, bytes.length, to));
      return true;
    } catch (PortUnreachableException e) {
      return false; // who waits for an answer there is told by its silence
    } catch (IOException | IllegalArgumentException e) {
      if (!socket.isClosed() && throttle.admit()) {
        LOG.warn("{}: nothing can be sent to {}: {}", name, to, e.getMessage());
      }
      return false;
    }
  }

  @Override
  public void close() {
    socket.close();
    workers.join(System.nanoTime() + ENDING.toNanos());
  }
}
