package org.robotui.ros.internal.xmlrpc;

import java.io.Closeable;
import java.io.EOFException;
import java.io.IOException;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.time.Duration;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ConcurrentLinkedDeque;
import org.robotui.net.socket.CloseableSet;
import org.robotui.net.socket.DeadlineInput;
import org.robotui.net.socket.HostPort;
import org.robotui.ros.XmlRpcValue;

/**
 * Calls one XML-RPC server. Any thread may call; each call has a connection of its own while it runs, and leaves it
 * open for the next one. Closing the client ends running calls with an error.
 */
public final class XmlRpcClient implements Closeable {

  private final HostPort target;
  private final XmlRpcLimits limits;
  private final CloseableSet connections = new CloseableSet();
  private final Deque<Connection> idle = new ConcurrentLinkedDeque<>();

  private record Connection(Socket socket, DeadlineInput in) implements Closeable {

    @Override
    public void close() throws IOException {
      socket.close();
    }
  }

  public XmlRpcClient(HostPort target, XmlRpcLimits limits) {
    this.target = target;
    this.limits = limits;
  }

  public HostPort target() {
    return target;
  }

  /** Calls with the standard time-out. */
  public XmlRpcValue call(String method, List<XmlRpcValue> arguments) throws IOException, XmlRpcFault {
    return call(method, arguments, limits.message());
  }

  /** Calls and waits so long at most, once for connecting and once for the answer. */
  public XmlRpcValue call(String method, List<XmlRpcValue> arguments, Duration timeout)
      throws IOException, XmlRpcFault {
    byte[] request = XmlRpcWriter.call(new MethodCall(method, arguments));
    return XmlRpcReader.response(exchange(request, method, timeout));
  }

  private byte[] exchange(byte[] body, String method, Duration timeout) throws IOException {
    try {
      Optional<byte[]> reused = onIdleConnection(body, timeout);
      return reused.isPresent() ? reused.get() : onConnection(body, connect(timeout), timeout);
    } catch (SocketTimeoutException e) {
      throw new SocketTimeoutException(method + " at " + target + " timed out");
    }
  }

  /** A kept connection may have been closed by the server meanwhile: then the call is made again on a new one. */
  private Optional<byte[]> onIdleConnection(byte[] body, Duration timeout) throws IOException {
    Optional<Connection> kept = Optional.ofNullable(idle.poll());
    if (kept.isEmpty()) {
      return Optional.empty();
    }
    try {
      return Optional.of(onConnection(body, kept.get(), timeout));
    } catch (EOFException | java.net.SocketException e) {
      return Optional.empty();
    }
  }

  private Connection connect(Duration timeout) throws IOException {
    Socket socket = new Socket();
    if (!connections.add(socket)) {
      throw new IOException("closed");
    }
    try {
      socket.setTcpNoDelay(true);
      target.connect(socket, timeout.compareTo(limits.connect()) < 0 ? timeout : limits.connect());
      return new Connection(socket, new DeadlineInput(socket, XmlRpcServer.BUFFER));
    } catch (IOException e) {
      connections.close(socket);
      throw e;
    }
  }

  private byte[] onConnection(byte[] body, Connection connection, Duration timeout) throws IOException {
    boolean done = false;
    try {
      connection.in().within(timeout);
      send(body, connection.socket());
      HttpHead head = HttpHead.read(connection.in());
      byte[] answer = Body.read(connection.in(), head.contentLength(limits.maxBody()), bytes -> {});
      requireOk(head);
      done = head.keepsAlive();
      return answer;
    } finally {
      release(connection, done);
    }
  }

  private void release(Connection connection, boolean reusable) {
    if (reusable) {
      idle.push(connection);
    } else {
      connections.close(connection.socket());
    }
  }

  /** The bytes of a call after which the server is to close the connection. */
  public byte[] words(MethodCall call) {
    byte[] body = XmlRpcWriter.call(call);
    return joined(HttpHead.bytes("POST / HTTP/1.1", "Host: " + target, "User-Agent: RobotUI", "Connection: close",
        "Content-Type: text/xml", "Content-Length: " + body.length), body);
  }

  private void send(byte[] body, Socket socket) throws IOException {
    socket.getOutputStream().write(joined(HttpHead.bytes("POST / HTTP/1.1", "Host: " + target, "User-Agent: RobotUI",
        "Content-Type: text/xml", "Content-Length: " + body.length), body));
  }

  private static byte[] joined(byte[] head, byte[] body) {
    byte[] all = Arrays.copyOf(head, head.length + body.length);
    System.arraycopy(body, 0, all, head.length, body.length);
    return all;
  }

  private static void requireOk(HttpHead head) throws XmlRpcException {
    String[] parts = head.firstLine().split(" ", 3);
    if (parts.length < 2 || !parts[0].startsWith("HTTP/1.") || !parts[1].equals("200")) {
      throw new XmlRpcException("HTTP answer '" + head.firstLine().strip() + "'");
    }
  }

  @Override
  public void close() {
    connections.close();
  }
}
