package org.robotui.lcm;

import java.io.IOException;
import java.net.BindException;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.util.concurrent.ThreadLocalRandom;

/** Ports for servers and groups of tests. */
public final class Ports {

  private Ports() {}

  /** Below the ports that the system hands out by itself: until it is bound, nobody else gets it by chance. */
  public static int free() throws IOException {
    for (int attempt = 0; attempt < 100; attempt++) {
      int port = ThreadLocalRandom.current().nextInt(15_000, 32_000);
      try (ServerSocket tcp = new ServerSocket(port, 1, InetAddress.getLoopbackAddress());
          DatagramSocket udp = new DatagramSocket(port)) {
        return tcp.getLocalPort();
      } catch (BindException e) {
        continue; // in use
      }
    }
    throw new IOException("no free port between 15000 and 32000");
  }
}
