package org.robotui.player.wire;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.EOFException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import org.junit.jupiter.api.Test;

class FramingTest {

  private static final DeviceAddress DEVICE = new DeviceAddress(0x0100007f, 6665, 4, 0);
  private static final PlayerMessage MESSAGE =
      new PlayerMessage(DEVICE, MessageType.DATA, 1, 12.5, 7, ByteBuffer.wrap(new byte[]{1, 2, 3, 4}));

  @Test
  void aMessageSurvivesTheWire() throws Exception {
    assertEquals(MESSAGE, Framing.read(stream(Framing.bytes(MESSAGE))));
  }

  @Test
  void theHostIsWrittenAsPeopleDo() {
    assertEquals("127.0.0.1", DEVICE.hostText());
  }

  @Test
  void anotherServersGreetingIsRefusedWithItsWords() {
    PlayerException e = assertThrows(PlayerException.class,
        () -> Framing.readBanner(
            new ByteArrayInputStream("SSH-2.0-OpenSSH_9.6 and more words\n".getBytes(StandardCharsets.US_ASCII))));
    assertTrue(e.getMessage().contains("SSH-2.0-OpenSSH_9.6"), e.getMessage());
  }

  @Test
  void theEndBetweenMessagesIsNotThatInsideOne() {
    byte[] bytes = Framing.bytes(MESSAGE).array();

    assertEquals("the peer closed the connection",
        assertThrows(EOFException.class, () -> Framing.read(stream(ByteBuffer.allocate(0)))).getMessage());
    EOFException cut =
        assertThrows(EOFException.class, () -> Framing.read(new ByteArrayInputStream(bytes, 0, bytes.length - 1)));
    assertTrue(cut.getMessage().contains("3 of 4 bytes"), cut.getMessage());
  }

  @Test
  void aLengthBeyondPlayersIsRefusedBeforeAByteIsRead() {
    PlayerException e = assertThrows(PlayerException.class, () -> Framing.read(stream(with(36, 0x7fffffff))));
    assertTrue(e.getMessage().contains("2147483647"), e.getMessage());
    assertThrows(PlayerException.class, () -> Framing.read(stream(with(36, -1))));
  }

  @Test
  void aLyingLengthTakesNoMemory() {
    // a thousand peers that announce the longest message and send nothing would need 8 GB
    for (int i = 0; i < 1_000; i++) {
      assertThrows(EOFException.class,
          () -> Framing.read(stream(with(36, PlayerMessage.MAX_BYTES - PlayerMessage.HEADER_BYTES))));
    }
  }

  @Test
  void unknownTypesAndNumbersBeyondTheirRangeAreRefused() {
    assertTrue(
        assertThrows(PlayerException.class, () -> Framing.read(stream(with(16, 9)))).getMessage().contains("type 9"));
    assertThrows(PlayerException.class, () -> Framing.read(stream(with(16, 0))));
    assertThrows(PlayerException.class, () -> Framing.read(stream(with(20, 256))));
    assertThrows(PlayerException.class, () -> Framing.read(stream(with(8, 0x10000))));
  }

  @Test
  void arraysCannotLieAboutTheirLength() {
    byte[] bytes = new byte[12];
    Arrays.fill(bytes, 0, 4, (byte) 0x7f);
    XdrReader lying = new XdrReader(ByteBuffer.wrap(bytes));
    assertThrows(PlayerException.class, () -> lying.count(4));
    assertThrows(PlayerException.class,
        () -> new XdrReader(ByteBuffer.wrap(new byte[]{0, 0, 0, 1, 0, 0, 0, 2})).sameCount(2));
    assertThrows(PlayerException.class, () -> new XdrReader(ByteBuffer.wrap(new byte[3])).i32());
    assertThrows(PlayerException.class, () -> new XdrReader(ByteBuffer.wrap(new byte[5])).bytes(5));
  }

  private static ByteBuffer with(int offset, int value) {
    return ByteBuffer.wrap(Framing.bytes(MESSAGE).array().clone()).putInt(offset, value);
  }

  private static InputStream stream(ByteBuffer bytes) {
    return new ByteArrayInputStream(bytes.array(), 0, bytes.limit());
  }
}
