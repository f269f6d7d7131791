package org.robotui.ros.internal.tcpros;

import java.io.IOException;
import java.net.Socket;
import java.net.SocketOption;
import java.net.StandardSocketOptions;
import java.util.Map;

/** The socket options of all TCPROS links. */
public final class Sockets {

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

  /**
   * Lets the kernel hold as little as it allows, on Linux about four small messages: nothing can be called back from it,
   * and after an outage it delivers all it was given meanwhile.
   */
  public static void entrustLittle(Socket socket) throws IOException {
    socket.setSendBufferSize(1);
  }

  @SuppressWarnings("unchecked")
  private static void probe(Socket socket, SocketOption<?> option) throws IOException {
    if (option.type() == Integer.class && PROBES.containsKey(option.name())) {
      socket.setOption((SocketOption<Integer>) option, PROBES.get(option.name()));
    }
  }
}
