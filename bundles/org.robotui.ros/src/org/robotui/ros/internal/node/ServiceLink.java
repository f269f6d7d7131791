package org.robotui.ros.internal.node;

import java.io.Closeable;
import java.io.IOException;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import org.robotui.net.call.Outcome;
import org.robotui.net.log.PeerText;
import org.robotui.net.socket.CloseableSet;
import org.robotui.net.socket.DeadlineInput;
import org.robotui.net.socket.HostPort;
import org.robotui.net.socket.Sockets;
import org.robotui.ros.internal.tcpros.ConnectionHeader;
import org.robotui.ros.internal.tcpros.FrameReader;
import org.robotui.ros.internal.tcpros.ProtocolException;

/** One connection to a service server. For one thread at a time; closing it from another one ends a call. */
final class ServiceLink implements Closeable {

  private static final long FRESH_NANOS = 100_000_000;

  private final NodeContext context;
  private final Socket socket;
  private final CloseableSet owner;
  private DeadlineInput stream;
  private FrameReader in;
  private ConnectionHeader header;
  private long lastUsed;

  ServiceLink(NodeContext context, CloseableSet owner) throws IOException {
    this.context = context;
    this.socket = context.options().sockets().createSocket();
    this.owner = owner;
  }

  /** Connects and exchanges headers. */
  void open(HostPort server, ConnectionHeader request, Deadline deadline) throws IOException {
    if (!owner.add(socket)) {
      throw new IOException("closed");
    }
    server.connect(socket, shorter(deadline.left(), context.handshake()));
    Sockets.prepare(socket);
    stream = new DeadlineInput(socket, 0);
    in = new FrameReader(stream, 8 * 1024);
    stream.within(shorter(deadline.left(), context.handshake()));
    socket.getOutputStream().write(request.encode());
    header = ConnectionHeader.decode(in.next(context.options().maxHeaderBytes(), "connection header"));
    if (header.field("error").isPresent()) {
      throw new ProtocolException("the server refused: " + PeerText.brief(header.require("error")));
    }
    lastUsed = System.nanoTime();
  }

  private static Duration shorter(Duration a, Duration b) {
    return a.compareTo(b) < 0 ? a : b;
  }

  ConnectionHeader header() {
    return header;
  }

  /** Sends a request with its length in front and reads the answer: the response's bytes, or the server's refusal. */
  Outcome<byte[]> exchange(byte[] request, Deadline deadline) throws IOException {
    stream.within(deadline.left());
    socket.getOutputStream().write(request);
    int ok = in.nextByte("its answer");
    byte[] answer = in.next(context.options().maxMessageBytes(), "response");
    lastUsed = System.nanoTime();
    if (ok > 1) {
      throw new ProtocolException("answer that starts with " + ok + " instead of 0 or 1");
    }
    return ok == 1 ? new Outcome.Done<>(answer)
        : new Outcome.Refused<>(PeerText.brief(new String(answer, StandardCharsets.UTF_8)));
  }

  /** Whether the server closed an idle connection, so that the next call is not spent on finding out. */
  boolean isStale() {
    if (System.nanoTime() - lastUsed < FRESH_NANOS) {
      return false;
    }
    try {
      stream.within(Duration.ofMillis(1));
      stream.read();
      return true;
    } catch (SocketTimeoutException e) {
      return false;
    } catch (IOException e) {
      return true;
    }
  }

  @Override
  public void close() {
    owner.close(socket);
  }
}
