package org.robotui.net.socket;

import java.io.Closeable;
import java.io.IOException;
import java.net.Socket;
import java.net.SocketOption;
import java.net.StandardSocketOptions;
import java.util.Map;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The options of TCP sockets that carry messages, and how they are closed. */
public final class Sockets {

  private static final Logger LOG = LoggerFactory.getLogger(Sockets.class);
  /** A half-open link is found after about 10 + 3 * 3 seconds without traffic. */
  private static final Map<String, Integer> PROBES =
      Map.of("TCP_KEEPIDLE", 10, "TCP_KEEPINTERVAL", 3, "TCP_KEEPCOUNT", 3);

  private Sockets() {}

  /**
   * Small messages go at once, and the kernel probes silent peers, so that the death of one is noticed within 20
   * seconds.
   *
   * @param socket connected or not
   * @throws IOException if the socket is closed
   */
  public static void prepare(Socket socket) throws IOException {
    socket.setTcpNoDelay(true);
    socket.setOption(StandardSocketOptions.SO_KEEPALIVE, true);
    for (SocketOption<?> option : socket.supportedOptions()) {
      probe(socket, option);
    }
  }

  /**
   * Lets the kernel hold as little as it allows, on Linux about four small messages: nothing can be called back from
   * it, and after an outage it delivers all that it was given meanwhile. Commands then wait with the sender, where
   * newer ones replace them.
   *
   * @param socket not connected yet
   * @throws IOException if the socket is closed
   */
  public static void minimizeSendBuffer(Socket socket) throws IOException {
    socket.setSendBufferSize(1);
  }

  /**
   * Closes without an error: nothing can be done about a socket that does not close.
   *
   * @param resource closed already or not
   */
  public static void closeQuietly(Closeable resource) {
    try {
      resource.close();
    } catch (IOException e) {
      LOG.debug("closing {}", resource, e);
    }
  }

  @SuppressWarnings("unchecked")
  private static void probe(Socket socket, SocketOption<?> option) throws IOException {
    if (option.type() == Integer.class && PROBES.containsKey(option.name())) {
      socket.setOption((SocketOption<Integer>) option, PROBES.get(option.name()));
    }
  }
}
