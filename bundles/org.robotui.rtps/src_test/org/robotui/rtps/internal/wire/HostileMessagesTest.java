package org.robotui.rtps.internal.wire;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.robotui.rtps.EndpointKind;
import org.robotui.rtps.EntityId;
import org.robotui.rtps.GuidPrefix;
import org.robotui.rtps.internal.discovery.EndpointCodec;
import org.robotui.rtps.internal.discovery.ParticipantCodec;
import org.robotui.testkit.ByteMutator;
import org.robotui.testkit.Effort;

/** Messages that nobody means: each is read, or refused with a reason, and nothing else happens. */
class HostileMessagesTest {

  private static final int MOST_BYTES = 2000;

  private static final int DOMAIN = 3;

  private int parts;

  private int refused;

  /** Goes on into what readers would read of a part. */
  private void read(byte[] datagram) {
    DatagramReader reader = new DatagramReader(new GuidPrefix(1, 1));
    try {
      reader.read(ByteBuffer.wrap(datagram), (context, part) -> {
        parts++;
        deeper(part);
      });
    } catch (WireException e) {
      refused++;
      assertTrue(e.getMessage().length() > 5 && e.getMessage().length() < 500, e.getMessage());
    }
  }

  private void deeper(Submessage.Exchanged part) {
    try {
      if (part instanceof Submessage.DataFrag frag) {
        InlineQos.read(frag.inlineQos());
        assertTrue(frag.payload().remaining() <= (long) frag.count() * frag.fragmentSize());
      } else if (part instanceof Submessage.Data data) {
        InlineQos.read(data.inlineQos());
        discovery(data);
      }
    } catch (WireException e) {
      refused++;
      assertTrue(e.getMessage().length() > 5, e.getMessage());
    }
  }

  private static void discovery(Submessage.Data data) throws WireException {
    if (data.content() == Submessage.Content.KEY) {
      EndpointCodec.readKey(data.payload());
    } else if (data.writer().equals(new EntityId(0x000100c2))) {
      ParticipantCodec.read(data.payload());
    } else if (data.writer().builtIn()) {
      EndpointCodec.read(data.payload(), data.writer().value() == 0x3c2 ? EndpointKind.WRITER : EndpointKind.READER);
    }
  }

  @ParameterizedTest
  @EnumSource
  void messages_may_end_anywhere(Recorded peer) {
    int cuts = 0;
    for (byte[] datagram : peer.toAll(MOST_BYTES, DOMAIN)) {
      for (int length = 0; length < datagram.length; length++) {
        read(Arrays.copyOf(datagram, length));
        cuts++;
      }
    }
    assertTrue(refused > cuts / 3 && parts > 0, "%d of %d refused".formatted(refused, cuts));
  }

  @ParameterizedTest
  @EnumSource
  void messages_may_be_damaged_anyhow(Recorded peer) {
    ByteMutator mutator = new ByteMutator(Effort.seed() + peer.ordinal());
    List<byte[]> all = peer.toAll(MOST_BYTES, DOMAIN);
    Effort effort = Effort.of(60_000, Duration.ofMinutes(5));
    while (effort.goesOn()) {
      read(mutator.mutate(all.get(mutator.random().nextInt(all.size()))));
    }
    assertTrue(refused > effort.rounds() / 10 && parts > effort.rounds() / 10, refused + " refused, read " + parts);
  }

  private static ByteBuffer message(int id, int flags, int length) {
    return ByteBuffer.allocate(200).putInt(0x52545053).putInt(0x02030000).put(new byte[12]).put((byte) id)
        .put((byte) flags).putShort((short) length);
  }

  private static String refusal(ByteBuffer message) {
    message.flip();
    return assertThrows(WireException.class, () -> new DatagramReader(new GuidPrefix(1, 1)).read(message,
        (context, part) -> {})).getMessage();
  }

  @Test
  void a_reason_says_what_and_where() {
    assertEquals("no RTPS message", refusal(ByteBuffer.allocate(100).putInt(0x52545058).put(new byte[20])));
    assertEquals("RTPS version 3.0", refusal(ByteBuffer.allocate(100).putInt(0x52545053).putInt(0x03000000)
        .put(new byte[12])));
    assertEquals("HEARTBEAT at byte 20 has 28 bytes, here are 4",
        refusal(message(SubmessageId.HEARTBEAT, 0, 28).putInt(0)));
    assertEquals("ACKNACK at byte 20: a set of 257 numbers",
        refusal(message(SubmessageId.ACKNACK, 0, 0).putLong(0).putLong(1).putInt(257).put(new byte[100])));
    assertEquals("HEARTBEAT at byte 20: samples from 5 to 3",
        refusal(message(SubmessageId.HEARTBEAT, 0, 0).putLong(0).putLong(5).putLong(3).putInt(1)));
    assertEquals("GAP at byte 20: a gap from 9 to 4",
        refusal(message(SubmessageId.GAP, 0, 0).putLong(0).putLong(9).putLong(4).putInt(0)));
    assertEquals("DATA at byte 20: sequence number -1",
        refusal(message(SubmessageId.DATA, 0, 0).putInt(16).putLong(0).putLong(-1)));
    assertEquals("DATA at byte 20: inline QoS at 17, of 16 to 16",
        refusal(message(SubmessageId.DATA, 0, 0).putInt(17).putLong(0).putLong(1)));
    assertEquals("INFO_REPLY at byte 20: 4294967295 locators",
        refusal(message(SubmessageId.INFO_REPLY, 0, 0).putInt(-1).putLong(0)));
  }

  @Test
  void fragments_lie_within_their_sample() {
    assertEquals("DATA_FRAG at byte 20: 1 fragments of 8 bytes from 3 on, of a sample of 16 bytes, in 8 bytes",
        refusal(fragment(3, 1, 8, 16)));
    assertEquals("DATA_FRAG at byte 20: 3 fragments of 4 bytes from 1 on, of a sample of 12 bytes, in 8 bytes",
        refusal(fragment(1, 3, 4, 12)));
    assertEquals("DATA_FRAG at byte 20: 1 fragments of 0 bytes from 1 on, of a sample of 12 bytes, in 8 bytes",
        refusal(fragment(1, 1, 0, 12)));
    assertEquals("DATA_FRAG at byte 20: 1 fragments of 8 bytes from 0 on, of a sample of 16 bytes, in 8 bytes",
        refusal(fragment(0, 1, 8, 16)));
    assertEquals("DATA_FRAG at byte 20: 9 fragments of 4 bytes from 1 on, of a sample of 8 bytes, in 8 bytes",
        refusal(fragment(1, 9, 4, 8)));
  }

  private static ByteBuffer fragment(int first, int count, int size, int sample) {
    return message(SubmessageId.DATA_FRAG, 0, 0).putInt(28).putLong(0).putLong(1).putInt(first).putShort((short) count)
        .putShort((short) size).putInt(sample).putLong(0);
  }

  @Test
  void what_nobody_knows_is_skipped() throws Exception {
    ByteBuffer message = message(0x80, 1, 0);
    message.order(ByteOrder.LITTLE_ENDIAN).putShort(22, (short) 4).putInt(0).order(ByteOrder.BIG_ENDIAN);
    message.put((byte) SubmessageId.PAD).put((byte) 0).putShort((short) 0);
    message.put((byte) SubmessageId.HEARTBEAT_FRAG).put((byte) 0).putShort((short) 32);
    message.putLong(0).putLong(1).putInt(2).putInt(3).putLong(-1).flip(); // and what a later version adds
    new DatagramReader(new GuidPrefix(1, 1)).read(message, (context, part) -> parts++);

    assertEquals(1, parts);
  }
}
