package org.robotui.ros.internal.node;

import java.io.EOFException;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.concurrent.locks.LockSupport;
import org.robotui.ros.internal.io.Closeables;
import org.robotui.ros.internal.io.PeerText;
import org.robotui.ros.internal.io.Seldom;
import org.robotui.ros.internal.tcpros.ConnectionHeader;
import org.robotui.ros.internal.tcpros.FrameReader;
import org.robotui.ros.internal.tcpros.ProtocolException;
import org.robotui.ros.internal.tcpros.Sockets;
import org.robotui.ros.internal.tcpros.TimedStream;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Accepts TCPROS connections of subscribers and service clients, and hands each to what it asks for. */
final class TcpServer {

  private static final Logger LOG = LoggerFactory.getLogger(TcpServer.class);
  private static final int MAX_CONNECTIONS = 2048;
  private static final int BUFFER = 8 * 1024;

  /** Where connections go, by their header. */
  interface Dispatch {

    /** Serves the connection until it ends. */
    void serve(Connection connection) throws IOException;
  }

  /** An accepted connection whose header was read. */
  record Connection(Socket socket, TimedStream stream, FrameReader in, ConnectionHeader header) { }

  private final NodeContext context;
  private final Dispatch dispatch;
  private final ServerSocket server = new ServerSocket();
  private final Closeables sockets = new Closeables();
  private final Seldom tooMany = new Seldom();
  private final Seldom refused = new Seldom();

  TcpServer(NodeContext context, InetAddress bind, Dispatch dispatch) throws IOException {
    this.context = context;
    this.dispatch = dispatch;
    try {
      server.bind(new InetSocketAddress(bind, 0), 128);
    } catch (IOException e) {
      server.close();
      throw e;
    }
  }

  void start() {
    context.start("tcpros", this::accept);
  }

  int port() {
    return server.getLocalPort();
  }

  private void accept() {
    while (!server.isClosed()) {
      try {
        handle(server.accept());
      } catch (IOException e) {
        if (!server.isClosed()) {
          LOG.warn("{}: accepting a connection failed: {}", context.name(), e.getMessage());
          LockSupport.parkNanos(50_000_000);
        }
      }
    }
  }

  private void handle(Socket socket) {
    if (sockets.size() >= MAX_CONNECTIONS) {
      if (tooMany.again()) {
        LOG.warn("{}: more than {} connections, {} refused so far", context.name(), MAX_CONNECTIONS, tooMany.count());
      }
      Closeables.quietly(socket);
    } else if (sockets.add(socket)) {
      context.start("in " + socket.getRemoteSocketAddress(), () -> serve(socket));
    }
  }

  private void serve(Socket socket) {
    try {
      Sockets.prepare(socket);
      TimedStream stream = new TimedStream(socket);
      stream.within(context.handshake());
      FrameReader in = new FrameReader(stream, BUFFER);
      ConnectionHeader header = ConnectionHeader.decode(in.next(context.options().maxHeaderBytes(), "connection header"));
      stream.withoutDeadline();
      dispatch.serve(new Connection(socket, stream, in, header));
    } catch (ProtocolException e) {
      if (refused.again()) {
        LOG.warn("{}: connection from {} refused: {} ({} so far)", context.name(), socket.getRemoteSocketAddress(),
            PeerText.brief(e.getMessage()), refused.count());
      }
      refuse(socket, e.getMessage());
    } catch (EOFException e) {
      LOG.debug("{}: connection from {} ended", context.name(), socket.getRemoteSocketAddress());
    } catch (IOException e) {
      LOG.debug("{}: connection from {} closed: {}", context.name(), socket.getRemoteSocketAddress(), e.getMessage());
    } finally {
      sockets.close(socket);
    }
  }

  private void refuse(Socket socket, String reason) {
    try {
      socket.getOutputStream().write(ConnectionHeader.error(context.name().text(), reason).encode());
    } catch (IOException e) {
      LOG.debug("{}: telling {} why it is refused failed", context.name(), socket, e);
    }
  }

  void close() {
    Closeables.quietly(server);
    sockets.close();
  }
}
