package org.robotui.rtps.internal.participant;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.time.Duration;
import java.util.List;
import java.util.OptionalInt;
import org.robotui.rtps.EndpointInfo;
import org.robotui.rtps.EndpointKind;
import org.robotui.rtps.EntityId;
import org.robotui.rtps.Guid;
import org.robotui.rtps.GuidPrefix;
import org.robotui.rtps.Locator;
import org.robotui.rtps.Locators;
import org.robotui.rtps.ParticipantInfo;
import org.robotui.rtps.ProtocolVersion;
import org.robotui.rtps.Qos;
import org.robotui.rtps.VendorId;
import org.robotui.rtps.internal.discovery.BuiltIn;
import org.robotui.rtps.internal.discovery.EndpointCodec;
import org.robotui.rtps.internal.discovery.ParticipantCodec;
import org.robotui.rtps.internal.wire.DatagramWriter;
import org.robotui.rtps.internal.wire.Submessage;

/** Says what it is told to, true or not, to one participant, and hears nothing. */
final class FakePeer implements AutoCloseable {

  private static final ByteOrder ORDER = ByteOrder.LITTLE_ENDIAN;

  private static final ByteBuffer NO_QOS = ByteBuffer.allocate(0).order(ORDER);

  private final DatagramSocket socket;

  private final InetSocketAddress discovery;

  private final InetSocketAddress user;

  private long announced;

  private Submessage last = new Submessage.InfoTimestamp(0);

  FakePeer(ParticipantInfo victim) throws IOException {
    socket = new DatagramSocket(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0));
    discovery = address(victim.metatraffic());
    user = address(victim.userTraffic());
  }

  private static InetSocketAddress address(Locators where) {
    return where.unicast().getFirst().socketAddress().orElseThrow();
  }

  static GuidPrefix prefix(int number) {
    return new GuidPrefix(0x0110_5555_0000_0000L, number);
  }

  /** Says that there is a participant, reached where this hears nothing. */
  void participant(GuidPrefix prefix, String name, Duration lease) {
    Locators here = new Locators(List.of(Locator.udp(socket.getLocalAddress(), socket.getLocalPort())), List.of());
    ParticipantInfo info = new ParticipantInfo(Guid.participant(prefix), VendorId.CYCLONE_DDS, ProtocolVersion.V2_3,
        name, OptionalInt.empty(), lease, BuiltIn.OURS, here, here, ByteBuffer.allocate(0));
    discovery(prefix, new Submessage.Data(BuiltIn.PARTICIPANT_READER, BuiltIn.PARTICIPANT_WRITER, 1, NO_QOS,
        Submessage.Content.SAMPLE, ParticipantCodec.write(info, ORDER)));
  }

  /** Says that a participant has a writer, and gives the writer. */
  EntityId writer(GuidPrefix prefix, int key, String topic, Qos qos, int userBytes) {
    EntityId writer = EntityId.user(key, EndpointKind.WRITER, false);
    EndpointInfo info = new EndpointInfo(new Guid(prefix, writer), EndpointKind.WRITER, topic, "type", qos,
        ByteBuffer.allocate(userBytes), Locators.NONE, false);
    announced++;
    last = new Submessage.Data(BuiltIn.PUBLICATIONS_READER, BuiltIn.PUBLICATIONS_WRITER, announced, NO_QOS,
        Submessage.Content.SAMPLE, EndpointCodec.write(info, ORDER));
    repeat(prefix);
    return writer;
  }

  /** Says once more what it said last of a writer, as somebody does whose datagram may have been lost. */
  void repeat(GuidPrefix prefix) {
    discovery(prefix, last);
  }

  void discovery(GuidPrefix prefix, Submessage part) {
    send(prefix, part, discovery);
  }

  void user(GuidPrefix prefix, Submessage part) {
    send(prefix, part, user);
  }

  private void send(GuidPrefix prefix, Submessage part, InetSocketAddress to) {
    DatagramWriter writer = new DatagramWriter(prefix, 65_000, ORDER);
    writer.add(part);
    ByteBuffer datagram = writer.finish();
    byte[] bytes = new byte[datagram.remaining()];
    datagram.get(bytes);
    raw(bytes, to);
  }

  /** Whatever it is. */
  void raw(byte[] bytes) {
    raw(bytes, discovery);
    raw(bytes, user);
  }

  private void raw(byte[] bytes, InetSocketAddress to) {
    try {
      socket.send(new DatagramPacket(bytes, bytes.length, to));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Override
  public void close() {
    socket.close();
  }
}
