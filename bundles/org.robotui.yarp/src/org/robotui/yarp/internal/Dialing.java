package org.robotui.yarp.internal;

import java.io.IOException;
import java.net.Socket;
import java.time.Duration;
import javax.net.SocketFactory;
import org.robotui.net.socket.HostPort;
import org.robotui.net.socket.Sockets;

/** How ports and name servers are called. */
public final class Dialing {
  private Dialing() {}

  /** A connected socket, to be closed. */
  public static Socket connect(SocketFactory sockets, HostPort where, Duration patience) throws IOException {
    Socket socket = sockets.createSocket();
    try {
      Sockets.minimizeSendBuffer(socket);
      where.connect(socket, patience);
      Sockets.prepare(socket);
      return socket;
    } catch (IOException | RuntimeException e) {
      Sockets.closeQuietly(socket);
      throw e;
    }
  }
}
