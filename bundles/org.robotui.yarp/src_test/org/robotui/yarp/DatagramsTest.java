package org.robotui.yarp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.testkit.ByteMutator;
import org.robotui.testkit.Effort;
import org.robotui.yarp.internal.DatagramAssembly;
import org.robotui.yarp.internal.DatagramPieces;
import org.robotui.yarp.wire.YarpFraming;
import org.robotui.yarp.wire.YarpMessage;
import org.robotui.yarp.wire.YarpStamp;

/** Messages in datagrams, which may be lost, doubled, damaged, or come in another order. */
class DatagramsTest {
  private static final int SHORT = 100;
  private static final int ROUNDS = 2_000;
  private static final Duration LONG = Duration.ofSeconds(20);

  private final DatagramAssembly assembly = new DatagramAssembly();
  private final List<YarpMessage> whole = new ArrayList<>();
  private final List<String> lost = new ArrayList<>();

  private static YarpMessage message(int number) {
    byte[] data = new byte[500];
    ByteBuffer.wrap(data).putInt(number);
    return YarpMessage.of(new YarpStamp(number, 1.5), data);
  }

  private static List<byte[]> pieces(int number) {
    return DatagramPieces.split(YarpFraming.bytes(message(number)), SHORT);
  }

  private void take(byte[] piece) {
    DatagramAssembly.Taken taken = assembly.take(ByteBuffer.wrap(piece));
    taken.message().ifPresent(whole::add);
    taken.lost().ifPresent(lost::add);
  }

  @Test
  void a_message_is_whole_with_its_last_datagram() {
    List<byte[]> pieces = pieces(1);
    assertEquals(6, pieces.size());
    pieces.subList(0, 5).forEach(this::take);
    assertEquals(List.of(), whole);
    take(pieces.getLast());
    pieces(2).forEach(this::take);
    assertEquals(List.of(message(1), message(2)), whole);
    assertEquals(List.of(), lost);
  }

  @Test
  void the_head_of_a_datagram_is_that_of_yarp() {
    byte[] piece = DatagramPieces.split("123456789".getBytes(StandardCharsets.US_ASCII), SHORT)
        .getFirst();
    assertEquals("2639f4cb00000000313233343536373839", HexFormat.of().formatHex(piece));
  }

  @Test
  void what_is_lost_costs_its_message_only() {
    List<byte[]> first = pieces(1);
    first.remove(3);
    first.forEach(this::take);
    pieces(2).forEach(this::take);
    List<byte[]> third = pieces(3);
    third.removeLast();
    third.forEach(this::take);
    pieces(4).forEach(this::take);
    assertEquals(List.of(message(2), message(4)), whole);
    assertTrue(lost.getFirst().contains("datagram 4 of a message came in place of 3"), lost::toString);
    assertEquals("a message ended early, after 5 datagrams", lost.getLast());
  }

  @Test
  void doubled_overtaken_and_damaged_datagrams_are_noticed() {
    List<byte[]> pieces = pieces(1);
    pieces.add(3, pieces.get(2));
    pieces.forEach(this::take);
    List<byte[]> turned = pieces(2);
    turned.add(1, turned.remove(2));
    turned.forEach(this::take);
    List<byte[]> damaged = pieces(3);
    damaged.get(2)[20] ^= 4;
    damaged.forEach(this::take);
    assertEquals(List.of(), whole);
    pieces(4).forEach(this::take);
    assertEquals(List.of(message(4)), whole);
    assertTrue(lost.contains("a datagram was damaged on its way"));
  }

  @Test
  void a_datagram_that_wakes_up_is_no_loss() {
    List<byte[]> pieces = pieces(1);
    pieces.add(2, new byte[]{0, 0, 0, 0, -1, -1, -1, -1, 0});
    pieces.forEach(this::take);
    assertEquals(List.of(message(1)), whole);
  }

  @Test
  void recorded_messages_are_the_same_after_their_way() {
    for (String connection : YarpCaptures.FROM_ROBOT) {
      for (YarpMessage message : YarpCaptures.messages(connection)) {
        DatagramPieces.split(YarpFraming.bytes(message), SHORT).forEach(this::take);
        assertEquals(Optional.of(message), whole.isEmpty() ? Optional.empty() : Optional.of(whole.removeLast()));
      }
    }
    assertEquals(List.of(), lost);
  }

  @Test
  void hostile_datagrams_are_refused_and_the_next_message_is_read() {
    ByteMutator mutator = new ByteMutator(2027 + Effort.seed());
    int refused = 0;
    for (Effort effort = Effort.of(ROUNDS, LONG); effort.goesOn();) {
      byte[] message = mutator.mutate(YarpFraming.bytes(message(1)));
      int before = lost.size();
      DatagramPieces.split(message, SHORT).forEach(this::take);
      refused += lost.size() - before;
      whole.clear();
      pieces(2).forEach(this::take);
      assertEquals(message(2), whole.getLast());
    }
    assertTrue(refused > 0, "some damages matter");
  }
}
