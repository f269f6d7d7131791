package org.robotui.lcm.internal.tcpq;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.time.Duration;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.LongAdder;
import org.robotui.lcm.internal.io.PeerText;
import org.robotui.lcm.internal.io.Seldom;
import org.robotui.lcm.internal.io.Workers;
import org.robotui.lcm.tcpq.TcpqServer;
import org.robotui.lcm.tcpq.TcpqServerOptions;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** A server and its clients. */
public final class ServerRuntime implements TcpqServer {

  private static final Logger LOG = LoggerFactory.getLogger(ServerRuntime.class);
  private static final Duration CLOSING = Duration.ofMillis(900);

  private final ServerSocket socket;
  private final TcpqServerOptions options;
  private final Workers workers;
  private final Set<ServerClient> clients = ConcurrentHashMap.newKeySet();
  private final LongAdder dropped = new LongAdder();
  private final LongAdder refused = new LongAdder();
  private final Seldom refusals = new Seldom();

  private ServerRuntime(ServerSocket socket, TcpqServerOptions options) {
    this.socket = socket;
    this.options = options;
    this.workers = new Workers(options.threads());
  }

  public static ServerRuntime open(TcpqServerOptions options) throws IOException {
    ServerSocket socket = new ServerSocket();
    try {
      socket.setReuseAddress(true);
      socket.bind(new InetSocketAddress(options.address(), options.port()));
    } catch (IOException e) {
      socket.close();
      throw new IOException("cannot listen on " + options.address().getHostAddress() + ":" + options.port() + ": " + e.getMessage(), e);
    }
    ServerRuntime server = new ServerRuntime(socket, options);
    server.workers.start("LCM server " + server.address(), server::accept);
    return server;
  }

  private void accept() {
    while (!socket.isClosed()) {
      try {
        take(socket.accept());
      } catch (IOException e) {
        LOG.debug("no more connections", e);
      }
    }
  }

  private void take(Socket connection) throws IOException {
    if (clients.size() >= options.maxClients()) {
      connection.close();
      refused(connection, "there are " + options.maxClients() + " clients already");
      return;
    }
    ServerClient client = new ServerClient(connection, options, this);
    clients.add(client);
    workers.start("LCM client " + connection.getRemoteSocketAddress(), client::read);
    if (socket.isClosed()) {
      client.close();
    }
  }

  /** A client's thread that writes. */
  void start(String name, Runnable work) {
    workers.start(name, work);
  }

  void route(Frames.Message message) {
    clients.forEach(client -> client.offer(message));
  }

  void countDropped() {
    dropped.increment();
  }

  void refused(Socket connection, String reason) {
    refused.increment();
    if (refusals.again()) {
      LOG.warn("LCM client {}: {} ({} refused so far)", connection.getRemoteSocketAddress(), PeerText.brief(reason), refusals.count());
    }
  }

  void ended(ServerClient client) {
    clients.remove(client);
  }

  @Override
  public InetSocketAddress address() {
    return new InetSocketAddress(socket.getInetAddress(), socket.getLocalPort());
  }

  @Override
  public int clients() {
    return (int) clients.stream().filter(ServerClient::isGreeted).count();
  }

  @Override
  public long dropped() {
    return dropped.sum();
  }

  @Override
  public long refused() {
    return refused.sum();
  }

  @Override
  public void close() {
    try {
      socket.close();
    } catch (IOException e) {
      LOG.debug("closing {}", socket, e);
    }
    clients.forEach(ServerClient::close);
    workers.join(System.nanoTime() + CLOSING.toNanos());
  }
}
