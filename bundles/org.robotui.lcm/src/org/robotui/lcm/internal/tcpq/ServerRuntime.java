package org.robotui.lcm.internal.tcpq;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.time.Duration;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.LongAdder;
import org.robotui.lcm.tcpq.TcpqServer;
import org.robotui.lcm.tcpq.TcpqServerOptions;
import org.robotui.net.log.LogThrottle;
import org.robotui.net.log.PeerText;
import org.robotui.net.socket.TcpListener;
import org.robotui.net.thread.Workers;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** A server and its clients. */
public final class ServerRuntime implements TcpqServer {

  private static final Logger LOG = LoggerFactory.getLogger(ServerRuntime.class);
  private static final Duration CLOSING = Duration.ofMillis(900);

  private final TcpListener listener;
  private final TcpqServerOptions options;
  private final Workers workers;
  private final Set<ServerClient> clients = ConcurrentHashMap.newKeySet();
  private final LongAdder dropped = new LongAdder();
  private final LongAdder refused = new LongAdder();
  private final LogThrottle refusals = new LogThrottle();

  private ServerRuntime(TcpListener listener, TcpqServerOptions options) {
    this.listener = listener;
    this.options = options;
    this.workers = new Workers(options.threads());
  }

  public static ServerRuntime open(TcpqServerOptions options) throws IOException {
    ServerRuntime server = new ServerRuntime(TcpListener.bind(options.address(), options.port()), options);
    String name = "LCM server " + server.address();
    server.workers.start(name, () -> server.listener.acceptAll(name, server::take));
    return server;
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
    if (listener.isClosed()) {
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
    if (refusals.admit()) {
      LOG.warn("LCM client {}: {} ({} refused so far)", connection.getRemoteSocketAddress(), PeerText.brief(reason),
          refusals.count());
    }
  }

  void ended(ServerClient client) {
    clients.remove(client);
  }

  @Override
  public InetSocketAddress address() {
    return listener.address();
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
    listener.close();
    clients.forEach(ServerClient::close);
    workers.join(System.nanoTime() + CLOSING.toNanos());
  }
}
