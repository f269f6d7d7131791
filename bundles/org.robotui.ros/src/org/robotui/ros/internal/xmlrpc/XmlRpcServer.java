package org.robotui.ros.internal.xmlrpc;

import java.io.Closeable;
import java.io.EOFException;
import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import org.robotui.net.log.LogThrottle;
import org.robotui.net.log.PeerText;
import org.robotui.net.socket.CloseableSet;
import org.robotui.net.socket.DeadlineInput;
import org.robotui.net.socket.Sockets;
import org.robotui.net.socket.TcpListener;
import org.robotui.net.thread.Workers;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** An HTTP server that answers XML-RPC calls, with one thread a connection and connections kept alive. */
public final class XmlRpcServer implements Closeable {

  static final int BUFFER = 8 * 1024;
  private static final Logger LOG = LoggerFactory.getLogger(XmlRpcServer.class);

  private final TcpListener listener;
  private final XmlRpcLimits limits;
  private final Workers workers;
  private final String name;
  private final BodyBudget budget;
  private final CloseableSet connections = new CloseableSet();
  private final LogThrottle refused = new LogThrottle();
  private final LogThrottle malformed = new LogThrottle();
  private final LogThrottle crowded = new LogThrottle();

  public XmlRpcServer(InetAddress bind, int port, XmlRpcLimits limits, Workers workers, String name)
      throws IOException {
    this.limits = limits;
    budget = new BodyBudget(limits.maxBodies());
    this.workers = workers;
    this.name = name;
    listener = TcpListener.bind(bind, port);
  }

  /** Starts accepting; apart from construction, so that the handler may know the port. */
  public void start(XmlRpcHandler handler) {
    workers.start(name + " http", () -> listener.acceptAll(name, socket -> serve(socket, handler)));
  }

  public int port() {
    return listener.port();
  }

  /** How much the large bodies take that are read or answered now. */
  long bodies() {
    return budget.taken();
  }

  private void serve(Socket socket, XmlRpcHandler handler) {
    if (connections.size() >= limits.maxConnections()) {
      if (refused.admit()) {
        LOG.warn("{}: more than {} connections, {} refused so far", name, limits.maxConnections(), refused.count());
      }
      Sockets.closeQuietly(socket);
    } else if (connections.add(socket)) {
      workers.start(name + " http " + socket.getRemoteSocketAddress(), () -> converse(socket, handler));
    }
  }

  private void converse(Socket socket, XmlRpcHandler handler) {
    try {
      socket.setTcpNoDelay(true);
      DeadlineInput in = new DeadlineInput(socket, BUFFER);
      boolean goOn = true;
      while (goOn && !listener.isClosed()) {
        in.nextMessage(limits.idle(), limits.message());
        goOn = answerOne(in, socket, handler);
      }
    } catch (XmlRpcException e) {
      refuse(socket, "400 Bad Request", e, malformed);
    } catch (BodyBudget.SpentException e) {
      refuse(socket, "503 Service Unavailable", e, crowded);
    } catch (EOFException | SocketTimeoutException e) {
      LOG.trace("{}: {} ended: {}", name, socket, e.getMessage());
    } catch (IOException e) {
      LOG.debug("{}: connection from {} closed: {}", name, socket.getRemoteSocketAddress(), e.getMessage());
    } finally {
      connections.close(socket);
    }
  }

  private boolean answerOne(DeadlineInput in, Socket socket, XmlRpcHandler handler) throws IOException {
    HttpHead head = HttpHead.read(in);
    if (!head.firstLine().startsWith("POST ")) {
      reply(socket, "405 Method Not Allowed", new byte[0], false);
      return false;
    }
    try (BodyBudget.Share share = budget.share()) {
      byte[] body = Body.read(in, head.contentLength(limits.maxBody()), share::grow);
      reply(socket, "200 OK", answer(XmlRpcReader.call(body), handler), head.keepsAlive());
    }
    return head.keepsAlive();
  }

  private void refuse(Socket socket, String status, IOException problem, LogThrottle alike) {
    if (alike.admit()) {
      LOG.warn("{}: refused a request from {}: {} ({} so far)", name, socket.getRemoteSocketAddress(),
          PeerText.brief(problem.getMessage()), alike.count());
    }
    try {
      reply(socket, status, PeerText.brief(problem.getMessage()).getBytes(StandardCharsets.UTF_8), false);
    } catch (IOException e) {
      LOG.debug("{}: telling {} why it is refused failed", name, socket, e);
    }
  }

  private byte[] answer(MethodCall call, XmlRpcHandler handler) {
    try {
      return XmlRpcWriter.response(handler.handle(call));
    } catch (XmlRpcFault e) {
      return XmlRpcWriter.fault(e);
    } catch (RuntimeException e) {
      LOG.error("{}: {} failed", name, call.method(), e);
      return XmlRpcWriter.fault(new XmlRpcFault(-32603, "internal error in " + call.method()));
    }
  }

  private static void reply(Socket socket, String status, byte[] body, boolean keepAlive) throws IOException {
    byte[] head = HttpHead.bytes("HTTP/1.1 " + status, "Content-Type: text/xml", "Content-Length: " + body.length,
        "Connection: " + (keepAlive ? "keep-alive" : "close"));
    byte[] all = Arrays.copyOf(head, head.length + body.length);
    System.arraycopy(body, 0, all, head.length, body.length);
    socket.getOutputStream().write(all);
  }

  @Override
  public void close() {
    listener.close();
    connections.close();
  }
}
