package org.robotui.roblets;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.SocketAddress;
import java.util.Optional;
import java.util.Random;

/** A way to a brain on which datagrams get lost, come twice and overtake each other; the way back is good. */
final class BadNetwork implements AutoCloseable {
  private final DatagramSocket near = new DatagramSocket(0, InetAddress.getLoopbackAddress());
  private final DatagramSocket far = new DatagramSocket(0, InetAddress.getLoopbackAddress());
  private final Random random = new Random(5);
  private volatile Optional<SocketAddress> roblet = Optional.empty();
  private Optional<DatagramPacket> kept = Optional.empty();

  BadNetwork(int brain) throws IOException {
    far.connect(InetAddress.getLoopbackAddress(), brain);
    TestBody.THREADS.newThread(() -> pass(near, this::there)).start();
    TestBody.THREADS.newThread(() -> pass(far, this::back)).start();
  }

  private interface Way {
    void take(DatagramPacket packet) throws IOException;
  }

  int port() {
    return near.getLocalPort();
  }

  private static void pass(DatagramSocket from, Way way) {
    while (!from.isClosed()) {
      try {
        DatagramPacket packet = new DatagramPacket(new byte[65_507], 65_507);
        from.receive(packet);
        way.take(packet);
      } catch (IOException e) {
        // the brain is away, or the test is over
      }
    }
  }

  private void there(DatagramPacket packet) throws IOException {
    roblet = Optional.of(packet.getSocketAddress());
    switch (random.nextInt(6)) {
      case 0 -> {
        // lost
      }
      case 1 -> {
        send(packet);
        send(packet);
      }
      case 2 -> {
        if (kept.isPresent()) {
          send(packet);
        } else {
          kept = Optional.of(packet);
        }
      }
      default -> {
        send(packet);
        if (kept.isPresent()) {
          send(kept.get());
          kept = Optional.empty();
        }
      }
    }
  }

  private void send(DatagramPacket packet) throws IOException {
    far.send(new DatagramPacket(packet.getData(), packet.getLength()));
  }

  private void back(DatagramPacket packet) throws IOException {
    if (roblet.isPresent()) {
      near.send(new DatagramPacket(packet.getData(), packet.getLength(), roblet.get()));
    }
  }

  @Override
  public void close() {
    near.close();
    far.close();
  }
}
