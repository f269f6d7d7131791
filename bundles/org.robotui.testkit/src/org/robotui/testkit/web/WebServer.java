package org.robotui.testkit.web;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.robotui.testkit.rfic.Peer;

/** A server of WebSockets on loopback. Safe for all threads. */
public final class WebServer implements AutoCloseable {
  private final ServerSocket listening;
  private final WebCaller caller;
  private final Set<Socket> callers = ConcurrentHashMap.newKeySet();

  /**
   * Opens it on a free port.
   *
   * @param caller says what to do with those who call
   * @throws IOException where there is no free port
   */
  public WebServer(WebCaller caller) throws IOException {
    this.caller = caller;
    this.listening = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
    Peer.THREADS.newThread(this::accept).start();
  }

  /**
   * Where it listens.
   *
   * @return a port of 127.0.0.1
   */
  public int port() {
    return listening.getLocalPort();
  }

  private void accept() {
    try {
      while (true) {
        Socket socket = listening.accept();
        callers.add(socket);
        Peer.THREADS.newThread(() -> serve(socket)).start();
      }
    } catch (IOException e) {
      // closed
    }
  }

  private void serve(Socket socket) {
    try (socket) {
      WebServerLink link = WebServerLink.greeted(socket);
      caller.opened(link);
      try {
        link.follow(caller);
      } finally {
        caller.closed(link);
      }
    } catch (IOException e) {
      // whoever called has gone
    } finally {
      callers.remove(socket);
    }
  }

  /** Breaks all links, without a word. */
  @Override
  public void close() {
    quietly(listening);
    callers.forEach(WebServer::quietly);
  }

  private static void quietly(AutoCloseable each) {
    try {
      each.close();
    } catch (Exception e) {
      // it is over in any case
    }
  }
}
