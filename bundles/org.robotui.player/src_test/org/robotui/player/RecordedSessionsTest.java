package org.robotui.player;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.robotui.player.interfaces.Fiducial;
import org.robotui.player.interfaces.Laser;
import org.robotui.player.interfaces.PlayerMap;
import org.robotui.player.interfaces.Position2d;
import org.robotui.player.interfaces.Pose2d;
import org.robotui.player.interfaces.Ranger;
import org.robotui.player.layout.Codec;
import org.robotui.player.layout.Kind;
import org.robotui.player.layout.Layouts;
import org.robotui.player.layout.PlayerRecord;
import org.robotui.player.wire.Framing;
import org.robotui.player.wire.MessageType;
import org.robotui.player.wire.PlayerException;
import org.robotui.player.wire.PlayerMessage;

/** What a real server and its clients said is understood to the last byte. */
class RecordedSessionsTest {

  private static final int ALL = 3996;

  private final Layouts layouts = Layouts.standard();

  static List<String> connections() {
    return Captures.NAMES;
  }

  @ParameterizedTest
  @MethodSource("connections")
  void everyMessageIsDecodedAndEncodedToTheSameBytes(String connection) throws PlayerException {
    for (PlayerMessage message : both(connection).toList()) {
      PlayerRecord record = layouts.decode(message);
      assertTrue(layouts.of(message).isPresent() || message.subtype() == 99 || message.subtype() == 77,
          message + " is not known");
      assertEquals(message.payload(), layouts.encode(record), () -> message + " as " + record.layout());
    }
  }

  @ParameterizedTest
  @MethodSource("connections")
  void theStreamsAreWrittenAsTheyWereRead(String connection) {
    assertEquals(ByteBuffer.wrap(Captures.bytes(connection + ".c2s.bin")), stream(Captures.fromClient(connection)));
    ByteBuffer fromServer = ByteBuffer.wrap(Captures.bytes(connection + ".s2c.bin"));
    assertEquals(Framing.banner("3.1.1-dev"), fromServer.slice(0, PlayerMessage.BANNER_BYTES));
    assertEquals(fromServer.position(PlayerMessage.BANNER_BYTES), stream(Captures.fromServer(connection)));
  }

  private static ByteBuffer stream(List<PlayerMessage> messages) {
    List<ByteBuffer> frames = messages.stream().map(Framing::bytes).toList();
    ByteBuffer all = ByteBuffer.allocate(frames.stream().mapToInt(ByteBuffer::remaining).sum());
    frames.forEach(all::put);
    return all.flip();
  }

  @ParameterizedTest
  @MethodSource("connections")
  void javaRecordsHoldTheSameAsWhatIsBrowsed(String connection) throws PlayerException {
    List<Kind> kinds = Kinds.all();
    for (PlayerMessage message : both(connection).filter(each -> each.type() != MessageType.NACK).toList()) {
      for (Kind kind : kinds) {
        if (isOf(message, kind)) {
          sameBytes(codec(message, kind), message.payload());
        }
      }
    }
  }

  private boolean isOf(PlayerMessage message, Kind kind) {
    MessageType type = message.type() == MessageType.ACK ? MessageType.REQUEST : message.type();
    return type == kind.wireType() && message.subtype() == layouts.message(kind).subtype()
        && layouts.byName(kind.on()).orElseThrow().code() == message.device().interfaceCode();
  }

  private Codec<?> codec(PlayerMessage message, Kind kind) {
    return switch (kind) {
      case Kind.Data<?> data -> layouts.codec(data);
      case Kind.Command<?> command -> layouts.codec(command);
      case Kind.Request<?, ?> request -> message.type() == MessageType.ACK ? layouts.answer(request)
          : layouts.question(request);
    };
  }

  private static <T> void sameBytes(Codec<T> codec, ByteBuffer payload) throws PlayerException {
    assertEquals(payload, codec.encode(codec.decode(payload)));
  }

  private static Stream<PlayerMessage> both(String connection) {
    return Stream.concat(Captures.fromClient(connection).stream(), Captures.fromServer(connection).stream());
  }

  @Test
  void allMessagesAreThere() {
    assertEquals(ALL, Captures.NAMES.stream().flatMap(RecordedSessionsTest::both).count());
  }

  @Test
  void theGreetingTellsTheVersion() throws Exception {
    assertEquals("3.1.1-dev", Framing.readBanner(new ByteArrayInputStream(Captures.bytes("position2d.s2c.bin"))));
  }

  @Test
  void theRobotIsWhereItWas() throws PlayerException {
    Position2d.State first = first("position2d", Position2d.STATE);

    assertEquals(new Pose2d(-6.946, -6.947, Math.PI / 4),
        new Pose2d(first.position().x(), first.position().y(), Math.PI / 4));
    assertEquals(Math.PI / 4, first.position().yaw(), 1e-6);
    assertFalse(first.stall());
  }

  @Test
  void distancesAreMetres() throws PlayerException {
    double[] sonar = first("rangers", Ranger.RANGES).ranges();
    assertEquals(16, sonar.length);
    assertEquals(1.3677536036354314, sonar[0]);

    Laser.Scan laser = first("rangers", Laser.SCAN);
    assertEquals(180, laser.ranges().length);
    assertEquals(8f, laser.ranges()[0]);
    assertEquals(8f, laser.maxRange());
  }

  @Test
  void whatIsInSightIsThere() throws PlayerException {
    List<Fiducial.Marker> markers = first("everything_robot0", Fiducial.SCAN).markers();

    assertEquals(List.of(18, 17, 17, 17, 17), markers.stream().map(Fiducial.Marker::id).toList());
    assertEquals(3.088, markers.getFirst().pose().x(), 1e-3);
  }

  @Test
  void mapsAreThere() throws PlayerException {
    PlayerMessage answer = Captures.fromServer("simulation_map_properties").stream()
        .filter(each -> each.device().interfaceCode() == 42 && each.subtype() == 3 && each.type() == MessageType.ACK)
        .findFirst().orElseThrow();
    PlayerMap.Vector lines = layouts.answer(PlayerMap.GET_VECTOR).decode(answer.payload());

    assertEquals(5, lines.segments().size());
    assertEquals(8f, lines.maxX());
    assertEquals(8, layouts.decode(answer).number("segments[1].x0").orElseThrow());
  }

  private <T> T first(String connection, Kind.Data<T> kind) throws PlayerException {
    PlayerMessage message =
        Captures.fromServer(connection).stream().filter(each -> isOf(each, kind)).findFirst().orElseThrow();
    return layouts.codec(kind).decode(message.payload());
  }
}
