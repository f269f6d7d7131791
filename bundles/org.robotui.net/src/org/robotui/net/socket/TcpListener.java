package org.robotui.net.socket;

import java.io.Closeable;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.concurrent.locks.LockSupport;
import org.robotui.net.log.LogThrottle;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** A port that clients connect to. Safe for all threads. */
public final class TcpListener implements Closeable {

  private static final Logger LOG = LoggerFactory.getLogger(TcpListener.class);
  private static final int BACKLOG = 128;
  /** Keeps a lack of file descriptors or threads from becoming a busy loop. */
  private static final long PAUSE_NANOS = 50_000_000;

  /** Takes over the connections. */
  @FunctionalInterface
  public interface Handler {

    /**
     * Takes a connection; returns at once, as no other client is accepted meanwhile.
     *
     * @param socket closed by the listener if this throws, else by whoever took it
     * @throws IOException if the connection ended already
     */
    void accept(Socket socket) throws IOException;
  }

  private final ServerSocket server;
  private final LogThrottle failures = new LogThrottle();

  private TcpListener(ServerSocket server) {
    this.server = server;
  }

  /**
   * Listens from now on; clients that connect wait for {@link #acceptAll}.
   *
   * @param address of which network interface
   * @param port 0 for any that is free
   * @return to be closed
   * @throws IOException if the port cannot be had; names it
   */
  public static TcpListener bind(InetAddress address, int port) throws IOException {
    ServerSocket server = new ServerSocket();
    try {
      server.setReuseAddress(true);
      server.bind(new InetSocketAddress(address, port), BACKLOG);
      return new TcpListener(server);
    } catch (IOException e) {
      server.close();
      throw new IOException("cannot listen on " + address.getHostAddress() + ":" + port + ": " + e.getMessage(), e);
    }
  }

  /**
   * Where it listens.
   *
   * @return the port that it has, also if any was asked for
   */
  public int port() {
    return server.getLocalPort();
  }

  /**
   * Where it listens.
   *
   * @return with the port that it has
   */
  public InetSocketAddress address() {
    return new InetSocketAddress(server.getInetAddress(), server.getLocalPort());
  }

  /**
   * Whether it was closed.
   *
   * @return then nothing is accepted any more
   */
  public boolean isClosed() {
    return server.isClosed();
  }

  /**
   * Accepts clients until closed. What one of them causes, and a lack of descriptors, memory or threads, ends only that
   * connection.
   *
   * @param name whose clients, for the log
   * @param handler takes them over, on this thread
   */
  public void acceptAll(String name, Handler handler) {
    while (!server.isClosed()) {
      try {
        hand(server.accept(), handler);
      } catch (IOException | OutOfMemoryError e) {
        pause(name, e);
      }
    }
  }

  private static void hand(Socket socket, Handler handler) throws IOException {
    boolean taken = false;
    try {
      handler.accept(socket);
      taken = true;
    } finally {
      if (!taken) {
        Sockets.closeQuietly(socket);
      }
    }
  }

  private void pause(String name, Throwable cause) {
    if (server.isClosed()) {
      return;
    }
    if (failures.admit()) {
      LOG.warn("{}: accepting a connection failed: {} ({} so far)", name, cause.getMessage(), failures.count());
    }
    LockSupport.parkNanos(PAUSE_NANOS);
  }

  /** Accepts nothing more; connections that were accepted go on. */
  @Override
  public void close() {
    Sockets.closeQuietly(server);
  }
}
