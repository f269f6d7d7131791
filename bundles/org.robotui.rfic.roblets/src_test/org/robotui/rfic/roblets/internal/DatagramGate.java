package org.robotui.rfic.roblets.internal;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.SocketAddress;
import java.util.Optional;
import org.robotui.testkit.rfic.Peer;

/** A door for datagrams before a brain: it keeps its address while brains come and go behind it, and can be held. */
final class DatagramGate implements AutoCloseable {
  private static final int LARGEST = 65_507;

  private final DatagramSocket near;
  private final DatagramSocket far;
  private volatile Optional<SocketAddress> brain = Optional.empty();
  private volatile Optional<SocketAddress> watcher = Optional.empty();
  private volatile boolean held;

  DatagramGate() throws IOException {
    near = new DatagramSocket(0, InetAddress.getLoopbackAddress());
    far = new DatagramSocket(0, InetAddress.getLoopbackAddress());
    Peer.THREADS.newThread(() -> pass(near, true)).start();
    Peer.THREADS.newThread(() -> pass(far, false)).start();
  }

  int port() {
    return near.getLocalPort();
  }

  void open(SocketAddress to) {
    brain = Optional.of(to);
  }

  void shut() {
    brain = Optional.empty();
  }

  void hold() {
    held = true;
  }

  void goOn() {
    held = false;
  }

  boolean holds() {
    return held;
  }

  private void pass(DatagramSocket from, boolean inwards) {
    while (!from.isClosed()) {
      try {
        DatagramPacket packet = new DatagramPacket(new byte[LARGEST], LARGEST);
        from.receive(packet);
        if (inwards) {
          watcher = Optional.of(packet.getSocketAddress());
        }
        Optional<SocketAddress> to = inwards ? brain : watcher;
        if (to.isPresent() && !held) {
          (inwards ? far : near).send(new DatagramPacket(packet.getData(), packet.getLength(), to.get()));
        }
      } catch (IOException e) {
        // nobody is there, or the test is over
      }
    }
  }

  /** In the name of the brain. */
  void inject(byte[] bytes) throws IOException {
    if (watcher.isPresent()) {
      near.send(new DatagramPacket(bytes, bytes.length, watcher.get()));
    }
  }

  @Override
  public void close() {
    near.close();
    far.close();
  }
}
