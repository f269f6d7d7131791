package org.robotui.guard.internal.process;

import java.io.Closeable;
import java.io.IOException;
import java.net.SocketOption;
import java.net.StandardSocketOptions;
import java.nio.channels.SocketChannel;
import java.util.Map;

/** How sockets are made ready and closed. */
final class Channels {
  /** A half-open link is found after about 10 + 3 * 3 seconds without traffic. */
  private static final Map<String, Integer> PROBES =
      Map.of("TCP_KEEPIDLE", 10, "TCP_KEEPINTERVAL", 3, "TCP_KEEPCOUNT", 3);

  private Channels() {}

  /**
   * A socket for a robot: small messages go at once, the kernel probes a silent peer, and holds little of what is sent,
   * since nothing can be called back from it.
   */
  static SocketChannel toRobot() throws IOException {
    SocketChannel channel = SocketChannel.open();
    channel.configureBlocking(false);
    channel.setOption(StandardSocketOptions.TCP_NODELAY, true);
    channel.setOption(StandardSocketOptions.SO_KEEPALIVE, true);
    channel.setOption(StandardSocketOptions.SO_SNDBUF, 1);
    for (SocketOption<?> option : channel.supportedOptions()) {
      probe(channel, option);
    }
    return channel;
  }

  @SuppressWarnings("unchecked")
  private static void probe(SocketChannel channel, SocketOption<?> option) throws IOException {
    if (option.type() == Integer.class && PROBES.containsKey(option.name())) {
      channel.setOption((SocketOption<Integer>) option, PROBES.get(option.name()));
    }
  }

  /** Nothing can be done about a channel that does not close. */
  static void quietly(Closeable resource) {
    try {
      resource.close();
    } catch (IOException e) {
      // it is gone all the same
    }
  }
}
