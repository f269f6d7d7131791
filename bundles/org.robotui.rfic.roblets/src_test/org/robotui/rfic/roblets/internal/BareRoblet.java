package org.robotui.rfic.roblets.internal;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.Arrays;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import org.robotui.roblets.tree.BodyElement;
import org.robotui.roblets.tree.BodyXml;
import org.robotui.roblets.tree.BodyXmlException;
import org.robotui.roblets.wire.BodyDatagram;
import org.robotui.roblets.wire.DatagramKind;
import org.robotui.roblets.wire.RobletForm;
import org.robotui.testkit.rfic.Peer;

/** A roblet of datagrams alone, which says what it is told to say, when it is told. */
final class BareRoblet implements AutoCloseable {
  private static final long BEACON_MILLIS = 200;

  private final RobletForm form;
  private final InetSocketAddress brain;
  private final Consumer<BodyElement> hears;
  private final DatagramSocket socket;
  private final long run = System.currentTimeMillis();
  private final AtomicLong sequence = new AtomicLong();

  BareRoblet(RobletForm form, int brain, Consumer<BodyElement> hears) throws IOException {
    this.form = form;
    this.brain = new InetSocketAddress(InetAddress.getLoopbackAddress(), brain);
    this.hears = hears;
    this.socket = new DatagramSocket(0, InetAddress.getLoopbackAddress());
    Peer.THREADS.newThread(this::beacons).start();
    Peer.THREADS.newThread(this::hear).start();
  }

  private void beacons() {
    while (!socket.isClosed()) {
      try {
        send(DatagramKind.BEACON, form.element().with("state", "running"), 0);
        Thread.sleep(BEACON_MILLIS);
      } catch (IOException | InterruptedException e) {
        return; // the test is over
      }
    }
  }

  private void hear() {
    BodyXml xml = new BodyXml();
    DatagramPacket packet = new DatagramPacket(new byte[BodyXml.MOST_BYTES], BodyXml.MOST_BYTES);
    while (!socket.isClosed()) {
      try {
        packet.setLength(BodyXml.MOST_BYTES);
        socket.receive(packet);
        BodyDatagram datagram = BodyDatagram.of(Arrays.copyOf(packet.getData(), packet.getLength()), xml);
        if (datagram.kind() == DatagramKind.MESSAGE) {
          hears.accept(datagram.body().orElseThrow());
        }
      } catch (BodyXmlException e) {
        throw new AssertionError(e);
      } catch (IOException e) {
        return; // the test is over
      }
    }
  }

  void say(BodyElement message, long stampNanos) throws IOException {
    send(DatagramKind.MESSAGE, message, stampNanos);
  }

  private void send(DatagramKind kind, BodyElement body, long stampNanos) throws IOException {
    byte[] bytes = new BodyDatagram(kind, form.name(), run, sequence.incrementAndGet(), stampNanos, "brain",
        Optional.of(body)).bytes();
    socket.send(new DatagramPacket(bytes, bytes.length, brain));
  }

  @Override
  public void close() {
    socket.close();
  }
}
