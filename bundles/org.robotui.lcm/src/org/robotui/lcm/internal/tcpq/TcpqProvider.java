package org.robotui.lcm.internal.tcpq;

import java.io.IOException;
import java.net.Socket;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.robotui.lcm.LcmOptions;
import org.robotui.lcm.LcmUrl;
import org.robotui.lcm.internal.client.Inlet;
import org.robotui.lcm.internal.client.Link;
import org.robotui.lcm.internal.client.Provider;
import org.robotui.net.socket.HostPort;
import org.robotui.net.socket.Sockets;

/** A client of a server of messages, as a URL describes it. */
public final class TcpqProvider implements Provider {

  private static final String STANDARD = "127.0.0.1:7700";
  private static final Pattern ADDRESS =
      Pattern.compile("([A-Za-z0-9._-]{1,255}|\\[[0-9a-fA-F:.]{2,45}\\])(?::(\\d{1,5}))?");

  private final HostPort server;
  private final LcmOptions options;
  private final Inlet inlet;

  private TcpqProvider(HostPort server, LcmOptions options, Inlet inlet) {
    this.server = server;
    this.options = options;
    this.inlet = inlet;
  }

  public static TcpqProvider of(LcmUrl url, LcmOptions options, Inlet inlet) {
    Matcher address = ADDRESS.matcher(url.network().isEmpty() ? STANDARD : url.network());
    int port = address.matches() ? Integer.parseInt(Optional.ofNullable(address.group(2)).orElse("7700")) : 0;
    if (port < 1 || port > 65535) {
      throw new IllegalArgumentException(
          "'" + url + "': '" + url.network() + "' is no host with a port; write for example tcpq://" + STANDARD);
    }
    return new TcpqProvider(new HostPort(address.group(1).replaceAll("[\\[\\]]", ""), port), options, inlet);
  }

  @Override
  public Link open() throws IOException {
    Socket socket = options.sockets().createSocket();
    try {
      socket.connect(server.resolve(), (int) options.connectTime().toMillis());
      Sockets.prepare(socket);
      return TcpqLink.greet(socket, server.toString(), options, inlet);
    } catch (IOException | RuntimeException e) {
      socket.close();
      throw new IOException("cannot reach the LCM server " + server + ": " + e.getMessage(), e);
    }
  }
}
