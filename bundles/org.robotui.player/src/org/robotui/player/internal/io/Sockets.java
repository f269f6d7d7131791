package org.robotui.player.internal.io;

import java.io.Closeable;
import java.io.IOException;
import java.net.Socket;
import java.net.SocketOption;
import java.net.StandardSocketOptions;
import java.util.Map;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The options of all sockets, and how they are closed. */
public final class Sockets {

  private static final Logger LOG = LoggerFactory.getLogger(Sockets.class);
  /** A half-open link is found after about 10 + 3 * 3 seconds without traffic. */
  private static final Map<String, Integer> PROBES = Map.of("TCP_KEEPIDLE", 10, "TCP_KEEPINTERVAL", 3, "TCP_KEEPCOUNT", 3);

  private Sockets() {
  }

  /** Small messages go at once, and the kernel probes silent peers. */
  public static void prepare(Socket socket) throws IOException {
    socket.setTcpNoDelay(true);
    socket.setOption(StandardSocketOptions.SO_KEEPALIVE, true);
    for (SocketOption<?> option : socket.supportedOptions()) {
      probe(socket, option);
    }
  }

  /** Lets the kernel hold little of what is sent: nothing can be called back from it. Commands wait here, where newer ones replace them. */
  public static void entrustLittle(Socket socket) throws IOException {
    socket.setSendBufferSize(1);
  }

  /** Closes without an error: nothing can be done about a socket that does not close. */
  public static void quietly(Closeable resource) {
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
