package org.robotui.player.log;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.StringReader;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robotui.player.Captures;
import org.robotui.player.interfaces.Position2d;
import org.robotui.player.layout.InterfaceLayout;
import org.robotui.player.layout.Layouts;
import org.robotui.player.layout.MessageLayout;
import org.robotui.player.layout.PlayerRecord;
import org.robotui.player.wire.DeviceAddress;
import org.robotui.player.wire.MessageType;
import org.robotui.player.wire.PlayerException;
import org.robotui.player.wire.PlayerMessage;
import org.robotui.testkit.Effort;

class LogFileTest {

  private static final String LINE =
      "0000000025.110 16777343 6665 position2d 00 001 001 +00.339 -00.004 -0.122 +00.000 +00.000 +00.000 0";

  private final Layouts layouts = Layouts.standard();
  private final LogFormat format = new LogFormat(layouts);

  private List<PlayerMessage> read(String text) throws IOException, PlayerException {
    List<PlayerMessage> messages = new ArrayList<>();
    try (LogReader reader = new LogReader(new StringReader(text), format)) {
      for (Optional<PlayerMessage> next = reader.next(); next.isPresent(); next = reader.next()) {
        messages.add(next.get());
      }
      assertEquals(0, reader.unknown());
    }
    return messages;
  }

  private String written(List<PlayerMessage> messages) throws IOException, PlayerException {
    StringWriter out = new StringWriter();
    try (LogWriter writer = new LogWriter(out, format, "3.1.1-dev")) {
      for (PlayerMessage each : messages) {
        assertTrue(writer.write(each), each.toString());
      }
    }
    return out.toString();
  }

  @Test
  void theLogOfARealServerIsWrittenAsItWasRead() throws Exception {
    String recorded = new String(Captures.bytes("stage.log"), StandardCharsets.US_ASCII);
    List<PlayerMessage> messages = read(recorded);

    assertEquals(recorded, written(messages));
    assertEquals(520, messages.size());
  }

  @Test
  void aLineIsAMessage() throws Exception {
    PlayerMessage message = read(LINE).getFirst();
    Position2d.State state = layouts.codec(Position2d.STATE).decode(message.payload());

    assertEquals(0.339, state.position().x());
    assertEquals(-0.122, state.position().yaw());
    assertEquals(25.110, message.stamp());
    assertEquals("127.0.0.1", message.device().hostText());
    assertEquals(Optional.of(LINE), format.line(message));
  }

  @Test
  void everyKindOfLineSurvives() throws Exception {
    Set<String> kinds = new HashSet<>();
    for (InterfaceLayout known : layouts.all()) {
      for (MessageLayout message : known.messages()) {
        MessageType type = message.type() == MessageType.REQUEST ? MessageType.ACK : message.type();
        Optional<PlayerRecord> body = (type == MessageType.ACK ? message.answer() : message.payload())
            .map(struct -> PlayerRecord.of(struct, Map.of()));
        if (body.isPresent()) {
          DeviceAddress device = new DeviceAddress(0, 6665, known.code(), 3);
          PlayerMessage zeros = PlayerMessage.of(device, type, message.subtype(), layouts.encode(body.get()));
          Optional<String> line = format.line(zeros);
          line.ifPresent(each -> kinds.add(known.name() + " " + type + " " + message.subtype()));
          if (line.isPresent()) {
            assertEquals(Optional.of(zeros), format.message(line.get()), line.get());
          }
        }
      }
    }
    assertEquals(26, kinds.size(), kinds.toString());
  }

  @ParameterizedTest
  @CsvSource({"0.0005, %+07.3f, +00.001", "-0.0001, %+07.3f, -00.000", "2.5, %2d, ' 2'", "-1.5, %04.1f, -1.5",
      "1, %f, 1.000000",
      "NaN, %07.3f, '    nan'", "-Infinity, %.3f, -inf", "1234.5678, %+07.3f, +1234.568"})
  void numbersAreThoseOfPrintf(double value, String how, String text) {
    assertEquals(text, NumberFormat.of(how).write(value));
  }

  @ParameterizedTest
  @CsvSource(delimiter = '|', value = {"nonsense | line 1: the line ends too early",
      "1 1 1 hover 0 1 1 | line 1: there is no interface 'hover'",
      "1 1 1 position2d 00 9 1 | there is no message type 9",
      "1 1 1 position2d 00 1 1 0.1 | line 1: the line ends too early",
      "1 1 1 position2d 00 1 1 a 0 0 0 0 0 0 | 'a' is no number",
      "1 1 1 position2d 00 1 1 0 0 0 0 0 0 0 7 | 1 words are left over",
      "1 1 1 ranger 00 1 1 2000000000 0.5 | 2000000000 elements announced",
      "1 1 1 ranger 00 1 1 -1 | '-1' is no number of elements",
      "1 -1 1 ranger 00 1 1 0 | the line is not understood", "1 1 1 camera 0 1 1 1 1 8 1 0 1 XY | hexadecimal"})
  void errorsNameTheLine(String text, String problem) {
    PlayerException e = assertThrows(PlayerException.class, () -> read(text));
    assertTrue(e.getMessage().startsWith("line 1: ") && e.getMessage().contains(problem), e.getMessage());
  }

  @Test
  void damagedLinesAreReadOrRefused() {
    SplittableRandom random = new SplittableRandom(7);
    String marker = "1.0 1 6665 fiducial 00 001 001 1 7" + " +00.100".repeat(12);
    int refused = 0;
    for (int i = 0; i < Effort.rounds(2_000); i++) {
      StringBuilder line = new StringBuilder(random.nextBoolean() ? LINE : marker);
      line.setCharAt(random.nextInt(line.length()), (char) random.nextInt(32, 127));
      line.setLength(random.nextInt(3) == 0 ? random.nextInt(line.length()) : line.length());
      try {
        format.message(line.toString());
      } catch (PlayerException e) {
        refused++;
      }
    }
    assertTrue(refused > 0);
  }
}
