package org.robotui.player;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robotui.player.layout.FieldValue;
import org.robotui.player.layout.Layouts;
import org.robotui.player.layout.PlayerRecord;
import org.robotui.player.wire.Framing;
import org.robotui.player.wire.PlayerException;
import org.robotui.player.wire.PlayerMessage;
import org.robotui.testkit.Effort;

/** Damaged recordings lead to the declared exceptions only, quickly and without large allocations. */
class MutatedSessionsTest {

  private static final int ROUNDS = 400;
  private static final Duration LONG = Duration.ofSeconds(20);
  private static final int[] EVIL = {-1, Integer.MAX_VALUE, Integer.MIN_VALUE, 1 << 28, 1 << 16, 0, 1};
  /** Of a message: what is damaged behind that is but another picture. */
  private static final int FRONT = 300;

  private final Layouts layouts = Layouts.standard();
  private final SplittableRandom random = new SplittableRandom(2026);

  @ParameterizedTest
  @ValueSource(strings = {"position2d", "errors", "rangers", "simulation_map_properties", "everything_robot0",
      "dummy_devices"})
  @Timeout(1_200)
  void damagedMessagesAreRefusedOrDecoded(String connection) {
    List<PlayerMessage> kinds = oneOfEachKind(connection);
    int refused = 0;
    for (Effort effort = Effort.of(ROUNDS, LONG); effort.goesOn();) {
      PlayerMessage message = kinds.get(random.nextInt(kinds.size()));
      byte[] body = damage(message.payload());
      refused +=
          decodes(PlayerMessage.of(message.device(), message.type(), message.subtype(), ByteBuffer.wrap(body))) ? 0 : 1;
    }
    assertTrue(refused > 0, "some damages matter");
  }

  private static List<PlayerMessage> oneOfEachKind(String connection) {
    Set<List<Integer>> seen = new HashSet<>();
    List<PlayerMessage> kinds = new ArrayList<>(Captures.fromServer(connection));
    kinds.addAll(Captures.fromClient(connection));
    kinds.removeIf(each -> !each.payload().hasRemaining()
        || !seen.add(List.of(each.device().interfaceCode(), each.type().code(), each.subtype())));
    return kinds;
  }

  private boolean decodes(PlayerMessage message) {
    try {
      visit(layouts.decode(message));
      return true;
    } catch (PlayerException e) {
      return false;
    }
  }

  private static void visit(PlayerRecord record) {
    record.layout().fields().stream().map(field -> record.field(field.name()).orElseThrow()).forEach(value -> {
      switch (value) {
        case FieldValue.Nested nested -> visit(nested.value());
        case FieldValue.Many many -> many.values().stream().limit(10).forEach(MutatedSessionsTest::visit);
        default -> assertTrue(!value.toString().isEmpty());
      }
    });
  }

  @ParameterizedTest
  @ValueSource(strings = {"position2d", "errors", "two_devices_pull"})
  @Timeout(1_200)
  void damagedStreamsEndWithAnErrorOrTheirEnd(String connection) throws IOException {
    byte[] whole = Arrays.copyOf(Captures.bytes(connection + ".s2c.bin"), 20_000);
    int refused = 0;
    for (Effort effort = Effort.of(ROUNDS / 4, LONG); effort.goesOn();) {
      ByteArrayInputStream in = new ByteArrayInputStream(damage(ByteBuffer.wrap(whole)));
      in.skip(PlayerMessage.BANNER_BYTES);
      refused += readsToTheEnd(in) ? 0 : 1;
    }
    assertTrue(refused > 0, "some damages matter");
  }

  private static boolean readsToTheEnd(ByteArrayInputStream in) throws IOException {
    try {
      while (in.available() > 0) {
        Framing.read(in);
      }
      return true;
    } catch (EOFException | PlayerException e) {
      return false;
    }
  }

  private byte[] damage(ByteBuffer original) {
    byte[] bytes = new byte[original.remaining()];
    original.duplicate().get(bytes);
    return switch (random.nextInt(4)) {
      case 0 -> Arrays.copyOf(bytes, random.nextInt(bytes.length));
      case 1 -> Arrays.copyOf(bytes, bytes.length + 1 + random.nextInt(16));
      case 2 -> withEvilLength(bytes);
      default -> withFlippedBits(bytes);
    };
  }

  private byte[] withEvilLength(byte[] bytes) {
    int words = Math.min(FRONT, bytes.length) / Integer.BYTES;
    if (words > 0) {
      ByteBuffer.wrap(bytes).putInt(random.nextInt(words) * Integer.BYTES, EVIL[random.nextInt(EVIL.length)]);
    }
    return bytes;
  }

  private byte[] withFlippedBits(byte[] bytes) {
    for (int i = 0; i < 4; i++) {
      bytes[random.nextInt(Math.min(FRONT, bytes.length))] ^= (byte) (1 << random.nextInt(8));
    }
    return bytes;
  }
}
