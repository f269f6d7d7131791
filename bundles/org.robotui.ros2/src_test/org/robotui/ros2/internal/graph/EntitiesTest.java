package org.robotui.ros2.internal.graph;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.robotui.message.MessageException;
import org.robotui.message.description.TypeHash;
import org.robotui.rtps.EntityId;
import org.robotui.rtps.Guid;
import org.robotui.rtps.GuidPrefix;

class EntitiesTest {

  private static final GuidPrefix PREFIX = new GuidPrefix(0x010f112233445566L, 0x778899aa);

  private static Guid guid(int entity) {
    return new Guid(PREFIX, new EntityId(entity));
  }

  private static Entities sample() {
    return new Entities(guid(0x1c1), List.of(
        new Entities.Node("/", "talker", List.of(), List.of(guid(0x103), guid(0x203))),
        new Entities.Node("/arm", "joints", List.of(guid(0x304)), List.of())));
  }

  @Test
  void bothLengthsOfIdentifiersAreToldApart() throws MessageException {
    for (int bytes : new int[]{EntitiesCodec.GID_BYTES, EntitiesCodec.OLD_GID_BYTES}) {
      for (Entities each : List.of(sample(), new Entities(guid(0x1c1), List.of()))) {
        assertEquals(new EntitiesCodec.Decoded(each, bytes), EntitiesCodec.decode(EntitiesCodec.encode(each, bytes)));
      }
    }
  }

  @Test
  void noPartOfAMessageIsTakenForOne() {
    ByteBuffer whole = EntitiesCodec.encode(sample(), EntitiesCodec.GID_BYTES);
    // the last word may be padding of the transport
    for (int length = 0; length < whole.limit() - 3; length++) {
      ByteBuffer part = whole.slice(0, length);
      assertThrows(MessageException.class, () -> EntitiesCodec.decode(part), "of " + length + " bytes");
    }
  }

  @Test
  void damagedMessagesAreRefusedAndNothingElse() {
    Random random = new Random(7);
    byte[] bytes = new byte[EntitiesCodec.encode(sample(), EntitiesCodec.GID_BYTES).remaining()];
    int refused = 0;
    for (int i = 0; i < 20_000; i++) {
      EntitiesCodec.encode(sample(), EntitiesCodec.GID_BYTES).get(bytes);
      for (int change = 0; change <= random.nextInt(4); change++) {
        bytes[random.nextInt(bytes.length)] = (byte) random.nextInt(256);
      }
      try {
        EntitiesCodec.decode(ByteBuffer.wrap(bytes));
      } catch (MessageException e) {
        refused++;
      }
    }
    assertTrue(refused > 1000, refused + " were refused");
  }

  @Test
  void sumsAreFoundAmongWhatElseIsSaid() {
    TypeHash hash = new TypeHash("RIHS01_" + "0a".repeat(32));
    assertEquals(Optional.of(hash), UserData.hash(UserData.of(Optional.of(hash))));
    assertEquals(Optional.of(hash), UserData.hash(bytes("serviceid=abc;typehash=" + hash.text() + ";x=y")));
    for (String none : List.of("", "typehash=;", "typehash=RIHS01_00;", "typehash=RIHS01_" + "0".repeat(64) + ";",
        "\0\0\0", "typehash")) {
      assertEquals(Optional.empty(), UserData.hash(bytes(none)), none);
    }
  }

  private static ByteBuffer bytes(String text) {
    return StandardCharsets.ISO_8859_1.encode(text);
  }
}
