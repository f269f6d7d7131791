package org.robotui.rfic.smartsoft.internal.feed;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import javax.net.SocketFactory;
import org.robotui.net.socket.HostPort;
import org.robotui.smartsoft.naming.NamedService;
import org.robotui.smartsoft.naming.NamingClient;

/** What a naming service lists. A link that is lost is made anew when it is asked the next time. */
public final class NamingDirectory implements AutoCloseable {
  private final HostPort at;
  private final SocketFactory sockets;
  private final Duration patience;
  private volatile Optional<NamingClient> client = Optional.empty();
  private volatile boolean closed;

  public NamingDirectory(HostPort at, SocketFactory sockets, Duration patience) {
    this.at = at;
    this.sockets = sockets;
    this.patience = patience;
  }

  /** All services; blocks. For one thread. */
  public List<NamedService> list() throws IOException {
    if (client.isEmpty() || client.get().isOver()) {
      NamingClient made = NamingClient.connect(at, sockets, patience);
      client = Optional.of(made);
      if (closed) {
        made.close();
      }
    }
    return client.get().list();
  }

  /** Ends a list that is under way as well. */
  @Override
  public void close() {
    closed = true;
    client.ifPresent(NamingClient::close);
  }
}
