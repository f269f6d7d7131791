package org.robotui.testkit.rfic;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.SocketAddress;
import java.util.Optional;

/**
 * A door for datagrams before a peer on this machine: it keeps its address while peers come and go behind it, and can
 * be held or shut. To either side that is as if the machine of the other one had been switched off. Safe for all
 * threads.
 */
public final class DatagramGate implements AutoCloseable {
  private static final int LARGEST = 65_507;

  private final DatagramSocket near;
  private final DatagramSocket far;
  private volatile Optional<SocketAddress> peer = Optional.empty();
  private volatile Optional<SocketAddress> client = Optional.empty();
  private volatile boolean held;

  /**
   * Shut until it is opened.
   *
   * @throws IOException where there are no sockets
   */
  public DatagramGate() throws IOException {
    near = new DatagramSocket(0, InetAddress.getLoopbackAddress());
    far = new DatagramSocket(0, InetAddress.getLoopbackAddress());
    Thread.ofPlatform().daemon().start(() -> pass(near, true));
    Thread.ofPlatform().daemon().start(() -> pass(far, false));
  }

  /**
   * Where clients find it.
   *
   * @return a port on loopback
   */
  public int port() {
    return near.getLocalPort();
  }

  /**
   * Lets datagrams through.
   *
   * @param to the peer behind it
   */
  public void open(SocketAddress to) {
    peer = Optional.of(to);
  }

  /** Lets none in any more. */
  public void shut() {
    peer = Optional.empty();
  }

  /** Lets none through, either way. */
  public void hold() {
    held = true;
  }

  /** Lets datagrams through again. */
  public void goOn() {
    held = false;
  }

  /**
   * Whether it is held.
   *
   * @return true between {@link #hold} and {@link #goOn}
   */
  public boolean holds() {
    return held;
  }

  private void pass(DatagramSocket from, boolean inwards) {
    while (!from.isClosed()) {
      try {
        DatagramPacket packet = new DatagramPacket(new byte[LARGEST], LARGEST);
        from.receive(packet);
        if (inwards) {
          client = Optional.of(packet.getSocketAddress());
        }
        Optional<SocketAddress> to = inwards ? peer : client;
        if (to.isPresent() && !held) {
          (inwards ? far : near).send(new DatagramPacket(packet.getData(), packet.getLength(), to.get()));
        }
      } catch (IOException e) {
        // nobody is there, or the test is over
      }
    }
  }

  /**
   * Sends the client something in the name of the peer.
   *
   * @param bytes of the datagram
   * @throws IOException where it cannot be sent
   */
  public void inject(byte[] bytes) throws IOException {
    if (client.isPresent()) {
      near.send(new DatagramPacket(bytes, bytes.length, client.get()));
    }
  }

  @Override
  public void close() {
    near.close();
    far.close();
  }
}
