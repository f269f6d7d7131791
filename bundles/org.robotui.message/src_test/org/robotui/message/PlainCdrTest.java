package org.robotui.message;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** CDR without encapsulation, of types that are described in IDL with several structures in a text. */
class PlainCdrTest {

  private static final IdlDefinitions DEFINITIONS = new IdlDefinitions(Map.of("Near", """
      module Near {
        enum Colour { RED, GREEN, BLUE };
        struct Point { short x; double y; };
        struct Path { Colour colour; sequence<Point> points; Far::Place place; };
      };
      """, "Far", "module Far { struct Place { string name; }; };"));

  @Test
  void bothOrdersAreAlignedToTheBeginning() throws Exception {
    MessageSchema schema = DEFINITIONS.schema("Near/Path");
    DynamicMessage path = new DynamicCodec(schema).build(Map.of("colour", 2, "points",
        List.of(Map.of("x", 1, "y", 0.5)), "place", Map.of("name", "a")));
    assertEquals("02000000" + "01000000" + "0100000000000000" + "000000000000e03f" + "020000006100",
        hex(path, ByteOrder.LITTLE_ENDIAN));
    assertEquals("00000002" + "00000001" + "0001000000000000" + "3fe0000000000000" + "000000026100",
        hex(path, ByteOrder.BIG_ENDIAN));
  }

  private static String hex(DynamicMessage message, ByteOrder order) throws Exception {
    CdrWriter out = CdrWriter.plain(order);
    message.write(out);
    byte[] bytes = out.toByteArray();
    CdrReader in = new CdrReader(ByteBuffer.wrap(bytes), order);
    assertEquals(message, DynamicMessage.read(DEFINITIONS.schema(message.type()), in));
    return HexFormat.of().formatHex(bytes);
  }

  @Test
  void nothingMayFollow() throws Exception {
    MessageSchema schema = DEFINITIONS.schema("Far/Place");
    ByteBuffer longer = ByteBuffer.wrap(new byte[]{1, 0, 0, 0, 0, 0});
    assertThrows(MessageException.class,
        () -> DynamicMessage.read(schema, new CdrReader(longer, ByteOrder.LITTLE_ENDIAN)));
  }

  @Test
  void whatIsNotDescribedIsSaid() {
    assertThrows(DefinitionException.class, () -> DEFINITIONS.schema("Near/Nothing"));
    assertThrows(DefinitionException.class, () -> DEFINITIONS.schema("Nowhere/Path"));
  }
}
