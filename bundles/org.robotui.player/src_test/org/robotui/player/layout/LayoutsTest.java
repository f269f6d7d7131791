package org.robotui.player.layout;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.robotui.player.Kinds;
import org.robotui.player.wire.DeviceAddress;
import org.robotui.player.wire.MessageType;
import org.robotui.player.wire.PlayerException;
import org.robotui.player.wire.PlayerMessage;

class LayoutsTest {

  private static final DeviceAddress PLUGIN = new DeviceAddress(0, 6665, 150, 2);
  private static final String TEXT = """
      # Of a plugin
      interface 150 tank
      data    1 level   level
      request 1 empty

      struct level      # How full it is
        f32     height [m]
        probe[] probes
        f64[2]  ends
        string  name
      struct probe
        u8      wet
        pose2d  place
      """;

  private final Layouts layouts = Layouts.standard();

  static List<Kind> kinds() {
    return Kinds.all();
  }

  @ParameterizedTest
  @MethodSource("kinds")
  void everyJavaRecordFitsItsLayout(Kind kind) throws PlayerException {
    MessageLayout message = layouts.message(kind);
    switch (kind) {
      case Kind.Data<?> data -> roundTrip(layouts.codec(data), message.payload());
      case Kind.Command<?> command -> roundTrip(layouts.codec(command), message.payload());
      case Kind.Request<?, ?> request -> {
        roundTrip(layouts.question(request), message.payload());
        roundTrip(layouts.answer(request), message.answer());
      }
    }
  }

  private <T> void roundTrip(Codec<T> codec, Optional<StructLayout> struct) throws PlayerException {
    ByteBuffer zeros =
        struct.map(layout -> layouts.encode(PlayerRecord.of(layout, Map.of()))).orElse(ByteBuffer.allocate(0));
    assertEquals(zeros, codec.encode(codec.decode(zeros)));
  }

  @Test
  void everyInterfaceSaysWhatItsFieldsMean() {
    for (InterfaceLayout layout : layouts.all()) {
      for (StructLayout struct : layout.structs().values()) {
        assertTrue(!struct.comment().isEmpty(), struct + " of " + layout.name());
        struct.fields().forEach(
            field -> assertTrue(!field.comment().isEmpty(), field + " of " + layout.name() + " " + struct.name()));
      }
    }
  }

  @Test
  void aPluginsInterfaceIsAddedByItsText() throws PlayerException {
    Layouts more = layouts.with("tank.layout", TEXT);
    StructLayout level =
        more.byName("tank").orElseThrow().message(MessageType.DATA, 1).orElseThrow().payload().orElseThrow();
    PlayerRecord record = PlayerRecord.of(level, Map.of("height", 1.5, "name", "ä",
        "probes", List.of(Map.of("wet", 1, "place", Map.of("x", 2)), Map.of()), "ends", new double[]{3, 4}));

    PlayerRecord back = more.decode(PlayerMessage.of(PLUGIN, MessageType.DATA, 1, more.encode(record)));

    assertEquals(record, back);
    assertEquals(OptionalDouble.of(2), back.number("probes[0].place.x"));
    assertEquals(OptionalDouble.of(4), back.number("ends[1]"));
    assertEquals(Optional.of(new FieldValue.Text("ä")), back.at("name"));
    assertEquals(OptionalDouble.empty(), back.number("probes[2].place.x"));
    assertEquals(OptionalDouble.empty(), back.number("name"));
    assertEquals(Optional.empty(), back.at("no.such[3].thing"));
    assertEquals("m", level.field("height").orElseThrow().unit());
    assertEquals("tank:2", more.nameOf(PLUGIN));
  }

  @Test
  void whatIsNotKnownIsShownAsBytes() throws PlayerException {
    PlayerRecord record =
        layouts.decode(PlayerMessage.of(PLUGIN, MessageType.DATA, 1, ByteBuffer.wrap(new byte[]{1, 2, 3})));

    assertEquals(OptionalDouble.of(3), record.number("bytes[2]"));
    assertEquals("interface150:2", layouts.nameOf(PLUGIN));
  }

  @Test
  void aBodyThatIsNoneSaysWhereItFails() {
    DeviceAddress base = new DeviceAddress(0, 6665, 4, 0);
    PlayerException cut = assertThrows(PlayerException.class,
        () -> layouts.decode(PlayerMessage.of(base, MessageType.DATA, 1, ByteBuffer.allocate(20))));
    assertTrue(cut.getMessage().startsWith("position2d:0 data 1: state: position: yaw: the message ends at byte 20"),
        cut.getMessage());

    PlayerException longer = assertThrows(PlayerException.class,
        () -> layouts.decode(PlayerMessage.of(base, MessageType.DATA, 1, ByteBuffer.allocate(56))));
    assertTrue(longer.getMessage().contains("4 bytes are left over"), longer.getMessage());
  }

  @Test
  void valuesThatDoNotFitAreRefused() {
    StructLayout scan = layouts.byName("laser").orElseThrow().structs().get("scan");

    assertThrows(IllegalArgumentException.class, () -> PlayerRecord.of(scan, Map.of("angle", 1)));
    assertThrows(IllegalArgumentException.class, () -> PlayerRecord.of(scan, Map.of("max_range", "far")));
    assertThrows(IllegalArgumentException.class, () -> PlayerRecord.of(scan, Map.of("ranges", List.of("far"))));
    assertThrows(IllegalArgumentException.class, () -> PlayerRecord.of(scan, Map.of("ranges", 1)));
  }

  @ParameterizedTest
  @CsvSource(delimiter = '|', value = {
      "data 1 x y                                     | line 1: there is no type 'y'",
      "interface 7                                    | line 1: 'interface 7' is neither",
      "interface 7 x;datum 1 x                        | line 2: 'datum 1 x' is neither",
      "interface 7 x;struct a;  f33 b                 | line 3: there is no type 'f33'",
      "interface 7 x;struct a;  f32                   | line 3: 'f32' is no field",
      "interface 7 x;struct a;  b b;struct b;  a a    | contains itself",
      "interface 7 x;struct a;struct b;  f32 c        | line 2: the structure 'a' has no field",
      "interface 7 x;struct a;  f32 b;struct a        | line 4: the structure 'a' is described twice",
      "struct a;  f32 b                               | line 1: no line 'interface CODE NAME'",
      "interface 7 x;struct a;  f32 b;  f32 b         | line 4: the field 'b' is described twice",
      "interface 7 x;struct a;  count b;  f32 c       | line 3: there is no array 'b' to count"})
  void errorsOfADescriptionNameTheLine(String text, String problem) {
    String lines = (text.startsWith("data") ? "interface 7 z" : text).replace(';', '\n');
    String source = text.startsWith("data") ? text.strip() + "\n" + lines : lines;
    LayoutException e = assertThrows(LayoutException.class, () -> layouts.with("mine.layout", source));
    assertTrue(e.getMessage().startsWith("mine.layout, line ") && e.getMessage().contains(problem), e.getMessage());
  }
}
