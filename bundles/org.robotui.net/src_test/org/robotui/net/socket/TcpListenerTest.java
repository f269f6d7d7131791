package org.robotui.net.socket;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class TcpListenerTest {

  private static final InetAddress LOOPBACK = InetAddress.getLoopbackAddress();

  private final BlockingQueue<Socket> taken = new LinkedBlockingQueue<>();

  private Thread accepting(TcpListener listener, TcpListener.Handler handler) {
    return Thread.ofPlatform().daemon().start(() -> listener.acceptAll("test", handler));
  }

  @Test
  void whatOneClientCausesEndsOnlyItsConnection() throws Exception {
    try (TcpListener listener = TcpListener.bind(LOOPBACK, 0)) {
      int[] count = {0};
      accepting(listener, socket -> {
        switch (count[0]++) {
          case 0 -> throw new IOException("on purpose");
          case 1 -> throw new OutOfMemoryError("unable to create native thread, on purpose");
          default -> taken.add(socket);
        }
      });
      for (int i = 0; i < 2; i++) {
        try (Socket refused = new Socket(LOOPBACK, listener.port())) {
          assertEquals(-1, refused.getInputStream().read(), "closed");
        }
      }
      try (Socket good = new Socket(LOOPBACK, listener.port()); Socket accepted = taken.take()) {
        assertEquals(good.getLocalPort(), accepted.getPort());
      }
    }
  }

  @Test
  void closingEndsTheLoop() throws Exception {
    TcpListener listener = TcpListener.bind(LOOPBACK, 0);
    Thread thread = accepting(listener, taken::add);
    listener.close();
    thread.join();
    assertTrue(listener.isClosed());
  }

  @Test
  void aPortThatIsTakenIsNamed() throws IOException {
    try (TcpListener listener = TcpListener.bind(LOOPBACK, 0)) {
      String reason = assertThrows(IOException.class, () -> TcpListener.bind(LOOPBACK, listener.port())).getMessage();
      assertTrue(reason.contains("cannot listen on 127.0.0.1:" + listener.port()), reason);
    }
  }
}
