package org.robotui.ros.internal.tcpros;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.robotui.message.MessageInfo;
import org.robotui.testkit.Effort;

class ConnectionHeaderTest {

  private static final ConnectionHeader HEADER = ConnectionHeader.of("/node")
      .with(new MessageInfo("std_msgs/String", "992ce8a1687cec8c8bd883ec73ca41d1", "string data # a=b\n"))
      .with("topic", "/chatter");

  private static byte[] body(ConnectionHeader header) {
    byte[] encoded = header.encode();
    return Arrays.copyOfRange(encoded, 4, encoded.length);
  }

  @Test
  void whatIsWrittenIsReadBack() throws Exception {
    ConnectionHeader read = ConnectionHeader.decode(body(HEADER));
    assertEquals(HEADER, read);
    assertEquals("string data # a=b\n", read.messageInfo().definition());
    assertEquals("/chatter", read.require("topic"));
  }

  @Test
  void theLengthStandsInFront() {
    byte[] encoded = HEADER.encode();
    assertEquals(encoded.length - 4, encoded[0] & 0xff | (encoded[1] & 0xff) << 8);
  }

  @Test
  void missingFieldsAreNamed() {
    ProtocolException e = assertThrows(ProtocolException.class, () -> HEADER.require("md5"));
    assertEquals("connection header without field 'md5'", e.getMessage());
  }

  @Test
  void aFieldThatComesTwiceIsRefused() {
    byte[] once = body(ConnectionHeader.of("/a"));
    byte[] twice = Arrays.copyOf(once, once.length * 2);
    System.arraycopy(once, 0, twice, once.length, once.length);
    assertTrue(assertThrows(ProtocolException.class, () -> ConnectionHeader.decode(twice)).getMessage()
        .contains("'callerid' comes twice"));
  }

  @Test
  void mutatedHeadersAreReadOrRefusedButNeverCrash() {
    Random random = new Random(3);
    Effort effort = Effort.of(50_000, Duration.ofMinutes(3));
    int refused = 0;
    while (effort.goesOn()) {
      byte[] bytes = body(HEADER);
      for (int n = 1 + random.nextInt(4); n > 0; n--) {
        bytes[random.nextInt(bytes.length)] = (byte) (random.nextBoolean() ? random.nextInt(256) : -1);
      }
      refused += isRefused(Arrays.copyOf(bytes, bytes.length - random.nextInt(3))) ? 1 : 0;
    }
    assertTrue(refused > effort.rounds() / 5 && refused < effort.rounds(), "refused " + refused);
  }

  private static boolean isRefused(byte[] bytes) {
    try {
      ConnectionHeader.decode(bytes);
      return false;
    } catch (ProtocolException e) {
      return true;
    }
  }
}
