package org.robotui.lcm.internal.udpm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Which datagrams are let in when there is not room for all. */
class GateTest {

  private static final int CAPACITY = 10_000;
  private static final int PAYLOAD = 1000;
  private static final InetSocketAddress ONE = new InetSocketAddress("10.0.0.1", 7000);
  private static final InetSocketAddress OTHER = new InetSocketAddress("10.0.0.2", 7000);

  private final Gate gate = new Gate(CAPACITY);

  private static ByteBuffer fragment(int sequence, int number, int count) {
    return ByteBuffer.allocate(Wire.FRAGMENT_HEADER + PAYLOAD).putInt(Wire.FRAGMENT).putInt(sequence)
        .putInt(PAYLOAD * count)
        .putInt(PAYLOAD * number).putShort((short) number).putShort((short) count).rewind();
  }

  private boolean admits(InetSocketAddress from, int sequence, int number, long free) {
    return gate.admits(from, fragment(sequence, number, 4), free, 0);
  }

  @Test
  void aMessageIsRefusedFromItsFirstFragmentToItsLast() {
    for (int number = 0; number < 4; number++) {
      assertFalse(admits(ONE, 1, number, number == 0 ? 3000 : CAPACITY),
          "there is room again, but not for a message that misses its beginning");
    }
    assertTrue(admits(ONE, 2, 0, CAPACITY));
  }

  @Test
  void whatWasLetInKeepsItsRoomBeforeOthers() {
    long free = 6000;
    assertTrue(admits(ONE, 1, 0, free));
    free -= Wire.FRAGMENT_HEADER + PAYLOAD;
    assertFalse(admits(OTHER, 1, 0, free), "the rest of the first message needs 3060 of 4980");
    assertTrue(admits(ONE, 1, 1, free));
    assertTrue(admits(ONE, 1, 2, 0));
    assertTrue(admits(ONE, 1, 3, 0));
    assertTrue(admits(OTHER, 2, 0, 5000), "nothing is kept any more");
  }

  @Test
  void noRoomIsKeptForWhatNeverComes() {
    assertTrue(admits(ONE, 1, 0, 5000));
    assertTrue(admits(ONE, 2, 0, 5000), "the sender is at its next message");
    assertFalse(admits(OTHER, 1, 0, 5000));
    assertTrue(gate.admits(OTHER, fragment(2, 0, 4), 5000, 60_000_000), "60 ms later");
  }

  @Test
  void messagesLongerThanTheBacklogAndShortOnesAreLetIn() {
    assertTrue(gate.admits(ONE, fragment(1, 0, 40), CAPACITY, 0));
    assertTrue(gate.admits(ONE, ByteBuffer.allocate(12).putInt(Wire.SHORT).rewind(), 0, 0));
    assertTrue(gate.admits(ONE, ByteBuffer.allocate(3), 0, 0));
  }

  @Test
  void whateverCameNothingStaysKept() {
    Random random = new Random(5);
    for (int i = 0; i < 50_000; i++) {
      ByteBuffer datagram = fragment(random.nextInt(9), random.nextInt(4), 4);
      if (random.nextInt(4) == 0) {
        datagram.putInt(4 + random.nextInt(16), random.nextInt());
      }
      InetSocketAddress from = new InetSocketAddress("10.0.1." + random.nextInt(90), 7000);
      ByteBuffer before = datagram.duplicate();
      gate.admits(from, datagram, random.nextInt(CAPACITY), i * 1_000_000L);
      assertEquals(before, datagram, "the datagram stays as it is");
    }
    assertTrue(gate.admits(ONE, fragment(1, 0, 9), 9200, 51_000_000_000L));
  }
}
