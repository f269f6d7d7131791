package org.robotui.player.internal.server;

import java.io.Closeable;
import java.io.EOFException;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.time.Duration;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.locks.LockSupport;
import org.robotui.player.internal.io.Seldom;
import org.robotui.player.internal.io.Sockets;
import org.robotui.player.internal.io.Workers;
import org.robotui.player.layout.Layouts;
import org.robotui.player.server.ServerOptions;
import org.robotui.player.wire.PlayerException;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Accepts clients and runs their sessions. */
public final class Acceptor implements Closeable {

  private static final Logger LOG = LoggerFactory.getLogger(Acceptor.class);
  private static final Duration END = Duration.ofSeconds(2);
  private static final int BACKLOG = 64;
  private static final long PAUSE = 50_000_000;

  private final Layouts layouts;
  private final Registry registry;
  private final ServerOptions options;
  private final Workers workers;
  private final ServerSocket server = new ServerSocket();
  private final Set<Session> sessions = ConcurrentHashMap.newKeySet();
  private final Seldom refused = new Seldom();
  private volatile boolean closed;

  /** Listens at once. */
  public Acceptor(Layouts layouts, Registry registry, ServerOptions options) throws IOException {
    this.layouts = layouts;
    this.registry = registry;
    this.options = options;
    this.workers = new Workers(options.threads());
    try {
      server.setReuseAddress(true);
      server.bind(new InetSocketAddress(options.bind(), options.port()), BACKLOG);
    } catch (IOException e) {
      server.close();
      throw new IOException("cannot listen on " + options.bind().getHostAddress() + ":" + options.port() + ": " + e.getMessage(), e);
    }
    workers.start("player server " + port(), this::accept);
  }

  /** Where it listens. */
  public int port() {
    return server.getLocalPort();
  }

  private void accept() {
    while (!closed) {
      try {
        begin(server.accept());
      } catch (IOException e) {
        if (!closed) {
          LOG.warn("accepting a connection failed: {}", e.getMessage());
          LockSupport.parkNanos(PAUSE);
        }
      }
    }
  }

  private void begin(Socket socket) throws IOException {
    if (sessions.size() >= options.maxClients()) {
      complain(socket, "there are " + options.maxClients() + " clients already");
      Sockets.quietly(socket);
      return;
    }
    Sockets.prepare(socket);
    Session session = new Session(socket, layouts, registry, options);
    sessions.add(session);
    workers.start("player to " + socket.getRemoteSocketAddress(), () -> send(session));
    workers.start("player from " + socket.getRemoteSocketAddress(), () -> receive(session, socket));
    if (closed) {
      session.close();
    }
  }

  private void receive(Session session, Socket socket) {
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

  private static void send(Session session) {
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
    if (refused.again()) {
      LOG.warn("client {} refused: {} ({} so far)", socket.getRemoteSocketAddress(), reason, refused.count());
    }
  }

  @Override
  public void close() {
    closed = true;
    Sockets.quietly(server);
    sessions.forEach(Session::close);
    workers.join(System.nanoTime() + END.toNanos());
  }
}
