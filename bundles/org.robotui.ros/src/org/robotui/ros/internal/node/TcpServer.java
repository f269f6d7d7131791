package org.robotui.ros.internal.node;

import java.io.EOFException;
import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import org.robotui.net.log.LogThrottle;
import org.robotui.net.log.PeerText;
import org.robotui.net.socket.CloseableSet;
import org.robotui.net.socket.DeadlineInput;
import org.robotui.net.socket.Sockets;
import org.robotui.net.socket.TcpListener;
import org.robotui.ros.internal.tcpros.ConnectionHeader;
import org.robotui.ros.internal.tcpros.FrameReader;
import org.robotui.ros.internal.tcpros.ProtocolException;
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
  record Connection(Socket socket, DeadlineInput stream, FrameReader in, ConnectionHeader header) {}

  private final NodeContext context;
  private final Dispatch dispatch;
  private final TcpListener listener;
  private final CloseableSet sockets = new CloseableSet();
  private final LogThrottle tooMany = new LogThrottle();
  private final LogThrottle refused = new LogThrottle();

  TcpServer(NodeContext context, InetAddress bind, Dispatch dispatch) throws IOException {
    this.context = context;
    this.dispatch = dispatch;
    this.listener = TcpListener.bind(bind, 0);
  }

  void start() {
    context.start("tcpros", () -> listener.acceptAll(context.name().text(), this::handle));
  }

  int port() {
    return listener.port();
  }

  private void handle(Socket socket) {
    if (sockets.size() >= MAX_CONNECTIONS) {
      if (tooMany.admit()) {
        LOG.warn("{}: more than {} connections, {} refused so far", context.name(), MAX_CONNECTIONS, tooMany.count());
      }
      Sockets.closeQuietly(socket);
    } else if (sockets.add(socket)) {
      context.start("in " + socket.getRemoteSocketAddress(), () -> serve(socket));
    }
  }

  private void serve(Socket socket) {
    try {
      Sockets.prepare(socket);
      DeadlineInput stream = new DeadlineInput(socket, 0);
      stream.within(context.handshake());
      FrameReader in = new FrameReader(stream, BUFFER);
      ConnectionHeader header =
          ConnectionHeader.decode(in.next(context.options().maxHeaderBytes(), "connection header"));
      stream.withoutDeadline();
      dispatch.serve(new Connection(socket, stream, in, header));
    } catch (ProtocolException e) {
      if (refused.admit()) {
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
    listener.close();
    sockets.close();
  }
}
