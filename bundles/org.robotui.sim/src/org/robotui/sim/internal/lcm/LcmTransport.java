package org.robotui.sim.internal.lcm;

import java.io.IOException;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.nio.ByteBuffer;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.TimeUnit;
import org.robotui.lcm.Lcm;
import org.robotui.lcm.LcmOptions;
import org.robotui.lcm.LcmUrl;
import org.robotui.lcm.Subscription;
import org.robotui.lcm.SubscriptionOptions;
import org.robotui.lcm.tcpq.TcpqServer;
import org.robotui.lcm.tcpq.TcpqServerOptions;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Where messages go: multicast that does not leave this machine, on a port that nobody else uses, or a server of our
 * own where there is no multicast.
 *
 * @param lcm the connection
 * @param server the server, if there is one
 */
record LcmTransport(Lcm lcm, Optional<TcpqServer> server) implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(LcmTransport.class);
  private static final String GROUP = "udpm://239.255.76.67:";
  private static final String PROBE = "ROBOTUI_PROBE";
  private static final int TRIES = 40;
  private static final long PAUSE_MILLIS = 50;

  /**
   * Opens a connection, and sees that what is sent arrives.
   *
   * @param wanted where to; else what works is chosen
   * @throws IOException if nothing arrives there; for a user to read
   */
  static LcmTransport open(Optional<LcmUrl> wanted, ThreadFactory threads) throws IOException {
    if (wanted.isPresent()) {
      return new LcmTransport(working(wanted.get(), threads), Optional.empty());
    }
    return orServed(LcmUrl.of(GROUP + freePort() + "?ttl=0"), threads);
  }

  /** Takes multicast if it works, else a server. */
  static LcmTransport orServed(LcmUrl multicast, ThreadFactory threads) throws IOException {
    try {
      return new LcmTransport(working(multicast, threads), Optional.empty());
    } catch (IOException e) {
      LOG.warn("multicast does not work here, so LCM goes through a server: {}", e.getMessage());
      return served(threads);
    }
  }

  private static LcmTransport served(ThreadFactory threads) throws IOException {
    TcpqServer server = TcpqServer.open(TcpqServerOptions.loopback(threads, 0));
    try {
      return new LcmTransport(working(LcmUrl.of("tcpq://127.0.0.1:" + server.address().getPort()), threads),
          Optional.of(server));
    } catch (IOException e) {
      server.close();
      throw e;
    }
  }

  private static int freePort() throws IOException {
    try (DatagramSocket socket = new DatagramSocket(0, InetAddress.getLoopbackAddress())) {
      return socket.getLocalPort();
    }
  }

  private static Lcm working(LcmUrl url, ThreadFactory threads) throws IOException {
    Lcm lcm = Lcm.open(url, LcmOptions.standard(threads));
    try {
      probe(lcm);
      return lcm;
    } catch (IOException e) {
      lcm.close();
      throw e;
    }
  }

  private static void probe(Lcm lcm) throws IOException {
    CountDownLatch heard = new CountDownLatch(1);
    Subscription probe = lcm.subscribe(PROBE, SubscriptionOptions.direct(), message -> heard.countDown());
    String problem = "what is sent does not come back";
    try {
      for (int i = 0; i < TRIES; i++) {
        problem = sent(lcm).orElse(problem);
        if (heard.await(PAUSE_MILLIS, TimeUnit.MILLISECONDS)) {
          return;
        }
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      probe.close();
    }
    throw new IOException(lcm.url() + ": " + problem + " (" + lcm.state() + ")");
  }

  /** Sends the probe, or tells why that is not possible. */
  private static Optional<String> sent(Lcm lcm) {
    try {
      lcm.publish(PROBE, ByteBuffer.allocate(Long.BYTES));
      return Optional.empty();
    } catch (IOException e) {
      return Optional.of(e.getMessage());
    }
  }

  @Override
  public void close() {
    lcm.close();
    server.ifPresent(TcpqServer::close);
  }
}
