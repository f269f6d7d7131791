package org.robotui.lcm.internal.tcpq;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.robotui.lcm.LcmOptions;
import org.robotui.lcm.LcmUrl;
import org.robotui.lcm.internal.client.Inlet;
import org.robotui.lcm.internal.client.Link;
import org.robotui.lcm.internal.client.Provider;

/** A client of a server of messages, as a URL describes it. */
public final class TcpqProvider implements Provider {

  private static final String STANDARD = "127.0.0.1:7700";
  private static final Pattern ADDRESS = Pattern.compile("([A-Za-z0-9._-]{1,255}|\\[[0-9a-fA-F:.]{2,45}\\])(?::(\\d{1,5}))?");

  private final String host;
  private final int port;
  private final LcmOptions options;
  private final Inlet inlet;

  private TcpqProvider(String host, int port, LcmOptions options, Inlet inlet) {
    this.host = host;
    this.port = port;
    this.options = options;
    this.inlet = inlet;
  }

  public static TcpqProvider of(LcmUrl url, LcmOptions options, Inlet inlet) {
    Matcher address = ADDRESS.matcher(url.network().isEmpty() ? STANDARD : url.network());
    int port = address.matches() ? Integer.parseInt(Optional.ofNullable(address.group(2)).orElse("7700")) : 0;
    if (port < 1 || port > 65535) {
      throw new IllegalArgumentException("'" + url + "': '" + url.network() + "' is no host with a port; write for example tcpq://" + STANDARD);
    }
    return new TcpqProvider(address.group(1), port, options, inlet);
  }

  @Override
  public Link open() throws IOException {
    String server = host + ":" + port;
    Socket socket = options.sockets().createSocket();
    try {
      InetSocketAddress address = new InetSocketAddress(host, port);
      if (address.isUnresolved()) {
        throw new IOException("its name cannot be resolved");
      }
      socket.setTcpNoDelay(true);
      socket.connect(address, (int) options.connectTime().toMillis());
      return TcpqLink.greet(socket, server, options, inlet);
    } catch (IOException | RuntimeException e) {
      socket.close();
      throw new IOException("cannot reach the LCM server " + server + ": " + e.getMessage(), e);
    }
  }
}
