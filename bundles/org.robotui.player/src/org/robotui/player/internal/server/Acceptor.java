package org.robotui.player.internal.server;

import java.io.Closeable;
import java.io.EOFException;
import java.io.IOException;
import java.net.Socket;
import java.time.Duration;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.robotui.net.log.LogThrottle;
import org.robotui.net.socket.Sockets;
import org.robotui.net.socket.TcpListener;
import org.robotui.net.thread.Workers;
import org.robotui.player.layout.Layouts;
import org.robotui.player.server.ServerOptions;
import org.robotui.player.wire.PlayerException;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Accepts clients and runs their sessions. */
public final class Acceptor implements Closeable {

  private static final Logger LOG = LoggerFactory.getLogger(Acceptor.class);
  private static final Duration END = Duration.ofSeconds(2);

  private final Layouts layouts;
  private final Registry registry;
  private final ServerOptions options;
  private final Workers workers;
  private final TcpListener listener;
  private final Set<ClientSession> sessions = ConcurrentHashMap.newKeySet();
  private final LogThrottle refused = new LogThrottle();

  /** Listens at once. */
  public Acceptor(Layouts layouts, Registry registry, ServerOptions options) throws IOException {
    this.layouts = layouts;
    this.registry = registry;
    this.options = options;
    this.workers = new Workers(options.threads());
    this.listener = TcpListener.bind(options.bind(), options.port());
    String name = "player server " + port();
    workers.start(name, () -> listener.acceptAll(name, this::begin));
  }

  /** Where it listens. */
  public int port() {
    return listener.port();
  }

  private void begin(Socket socket) throws IOException {
    if (sessions.size() >= options.maxClients()) {
      complain(socket, "there are " + options.maxClients() + " clients already");
      Sockets.closeQuietly(socket);
      return;
    }
    Sockets.prepare(socket);
    ClientSession session = new ClientSession(socket, layouts, registry, options);
    sessions.add(session);
    workers.start("player to " + socket.getRemoteSocketAddress(), () -> send(session));
    workers.start("player from " + socket.getRemoteSocketAddress(), () -> receive(session, socket));
    if (listener.isClosed()) {
      session.close();
    }
  }

  private void receive(ClientSession session, Socket socket) {
    try {
      session.receive();
    } catch (PlayerException e) {
      complain(socket, e.getMessage());
    } catch (EOFException e) {
      LOG.debug("client {} left", socket.getRemoteSocketAddress());
    } catch (IOException e) {
      LOG.debug("client {}: {}", socket.getRemoteSocketAddress(), e.getMessage());
    } finally {
      sessions.remove(session);
      session.close();
    }
  }

  private static void send(ClientSession session) {
    try {
      session.send();
    } catch (IOException e) {
      LOG.debug("sending ended: {}", e.getMessage());
      session.close();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void complain(Socket socket, String reason) {
    if (refused.admit()) {
      LOG.warn("client {} refused: {} ({} so far)", socket.getRemoteSocketAddress(), reason, refused.count());
    }
  }

  /** Waits until all clients were told all; false where one did not read in time. */
  public boolean awaitSent(Duration patience) throws InterruptedException {
    long deadline = System.nanoTime() + patience.toNanos();
    boolean all = true;
    for (ClientSession each : sessions) {
      all &= each.awaitSent(deadline);
    }
    return all;
  }

  @Override
  public void close() {
    listener.close();
    sessions.forEach(ClientSession::close);
    workers.join(System.nanoTime() + END.toNanos());
  }
}
