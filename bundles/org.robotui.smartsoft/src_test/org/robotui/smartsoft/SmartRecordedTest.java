package org.robotui.smartsoft;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.robotui.message.DynamicMessage;
import org.robotui.message.MessageException;
import org.robotui.smartsoft.naming.ServiceAddress;
import org.robotui.smartsoft.naming.ServiceName;
import org.robotui.smartsoft.naming.SmartPattern;
import org.robotui.smartsoft.wire.NamingCommand;
import org.robotui.smartsoft.wire.SmartCommand;
import org.robotui.smartsoft.wire.SmartFrame;
import org.robotui.smartsoft.wire.SmartFraming;

/** Everything that was recorded is read, and written as it was. */
class SmartRecordedTest {

  static Stream<String> files() {
    return SmartCaptures.files();
  }

  /** Three bytes of each header are not initialised by senders; we write zeros. */
  @ParameterizedTest
  @MethodSource("files")
  void frames_are_written_as_they_were(String file) {
    byte[] expected = SmartCaptures.bytes(file);
    ByteArrayOutputStream written = new ByteArrayOutputStream();
    for (SmartFrame frame : SmartCaptures.frames(file)) {
      expected[written.size() + 1] = 0;
      expected[written.size() + 2] = 0;
      expected[written.size() + 3] = 0;
      written.writeBytes(new SmartFraming().bytes(frame));
    }
    assertArrayEquals(expected, written.toByteArray());
  }

  @ParameterizedTest
  @MethodSource("files")
  void both_parts_are_written_as_they_were(String file) throws MessageException {
    for (SmartFrame frame : SmartCaptures.frames(file)) {
      assertWritten(KnownParts.pattern(file, frame));
      assertWritten(KnownParts.object(file, frame));
    }
  }

  private static void assertWritten(Optional<KnownParts.Part> known) throws MessageException {
    if (known.isEmpty()) {
      return;
    }
    KnownParts.Part part = known.get();
    DynamicMessage read = part.type().read(part.bytes());
    ByteBuffer written = part.type().write(read, ByteOrder.LITTLE_ENDIAN);
    assertEquals(part.bytes().remaining(), written.remaining(), part.what());
    for (int i = 0; i < written.remaining(); i++) {
      if (part.bytes().get(i) != written.get(i)) {
        assertEquals(read, part.type().read(changed(part.bytes(), i)),
            part.what() + " has another byte at " + i + " that is no gap");
      }
    }
    ByteBuffer turned = part.type().write(read, ByteOrder.BIG_ENDIAN);
    assertEquals(read, part.type().read(turned), part.what() + " in the other order of bytes");
  }

  /** A gap is where any other byte means the same: senders leave there what was in their memory. */
  private static ByteBuffer changed(ByteBuffer bytes, int at) {
    ByteBuffer copy = ByteBuffer.allocate(bytes.remaining()).order(bytes.order());
    copy.put(bytes.duplicate()).flip();
    return copy.put(at, (byte) ~copy.get(at));
  }

  @Test
  void names_and_addresses_are_read() throws Exception {
    SmartFrame entry = SmartCaptures.frames("ns_event_client.s2c").stream()
        .filter(frame -> frame.command() == NamingCommand.RESOLVE).findFirst().orElseThrow();
    DynamicMessage said = read(KnownParts.pattern("ns_event_client.s2c", entry));
    ServiceAddress address = ServiceAddress.parse(said.text("value").orElseThrow());
    assertEquals(39_257, address.at().port());
    assertEquals("e75243b2-e565-11f1-8000-67c6697351ff", address.identifier());
    String written =
        read(KnownParts.pattern("ns_query_client.c2s", SmartCaptures.frames("ns_query_client.c2s").getFirst()))
            .text("name").orElseThrow();
    ServiceName name = ServiceName.parse(written).orElseThrow();
    assertEquals(written, name.toString());
    assertEquals(SmartPattern.QUERY, name.known().orElseThrow());
    assertEquals(2, name.types().size());
  }

  @Test
  void known_values_are_found() {
    List<SmartFrame> push = SmartCaptures.frames("push.s2c");
    double[] times = push.stream().filter(frame -> frame.command() == SmartCommand.UPDATE.number())
        .mapToDouble(frame -> read(KnownParts.object("push.s2c", frame)).number("seconds").orElseThrow()).toArray();
    assertEquals(9, times.length);
    assertEquals(1_795_236_128.0, times[0]);
    assertEquals(2, times[8] - times[7], "every second update");
    SmartFrame print = SmartCaptures.frames("send_a.c2s").get(1);
    assertEquals("Thread A", read(KnownParts.object("send_a.c2s", print)).text("text").orElseThrow());
    SmartFrame event = SmartCaptures.frames("event_interval.s2c").get(2);
    assertEquals("outside", read(KnownParts.object("event_interval.s2c", event)).text("text").orElseThrow());
    assertTrue(SmartCaptures.frames("query_calc.s2c").stream()
        .filter(frame -> frame.command() == SmartCommand.ANSWER.number())
        .map(frame -> read(KnownParts.object("query_calc.s2c", frame)).number("value").orElseThrow())
        .allMatch(sum -> sum == 6 || sum == 33));
  }

  /** The modes are those of the client's log: 1 again and again, 2 once. */
  @Test
  void activations_have_a_mode_and_then_a_number() {
    List<DynamicMessage> activations = SmartCaptures.frames("event_morethan.c2s").stream()
        .filter(frame -> frame.command() == SmartCommand.ACTIVATE.number())
        .map(frame -> read(KnownParts.pattern("event_morethan.c2s", frame))).toList();
    assertEquals(1, activations.get(0).number("mode").orElseThrow());
    assertEquals(1, activations.get(0).number("activation").orElseThrow());
    assertEquals(0, activations.get(1).number("mode").orElseThrow());
    assertEquals(2, activations.get(1).number("activation").orElseThrow());
  }

  private static DynamicMessage read(Optional<KnownParts.Part> part) {
    try {
      return part.orElseThrow().type().read(part.orElseThrow().bytes());
    } catch (MessageException e) {
      throw new AssertionError(e);
    }
  }
}
