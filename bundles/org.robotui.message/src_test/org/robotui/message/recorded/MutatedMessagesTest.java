package org.robotui.message.recorded;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.time.Duration;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robotui.message.DefinitionException;
import org.robotui.message.DynamicCodec;
import org.robotui.message.DynamicMessage;
import org.robotui.message.MessageException;
import org.robotui.message.MessageSchema;
import org.robotui.message.RecordCodec;
import org.robotui.message.RosValue;
import org.robotui.message.ShippedRecords;
import org.robotui.testkit.Effort;

/** Damaged bytes and definitions lead to the declared exceptions only, quickly and without large allocations. */
class MutatedMessagesTest {

  private static final int ROUNDS = 300;
  /** Of one message in a long run; the four recordings hold about thirty types. */
  private static final Duration LONG = Duration.ofSeconds(30);
  private static final int[] EVIL = {-1, Integer.MAX_VALUE, Integer.MIN_VALUE, 1 << 28, 1 << 16, 0};

  private final SplittableRandom random = new SplittableRandom(2026);

  @ParameterizedTest
  @ValueSource(strings = {"sena_loop.bag", "turtlesim.bag", "stereo_jpeg.bag", "marker_cube.bag"})
  @Timeout(1_200)
  void damagedMessagesAreRefusedOrDecoded(String bag) throws Exception {
    for (BagReader.Recorded each : oneOfEachType(bag)) {
      DynamicCodec dynamic =
          new DynamicCodec(MessageSchema.parse(each.info().type(), each.info().definition()));
      Optional<RecordCodec<?>> compiled = ShippedRecords.codec(each.info().type());
      int refused = 0;
      for (Effort effort = Effort.of(ROUNDS, LONG); effort.goesOn();) {
        byte[] damaged = damage(each.bytes());
        boolean accepted = tryDecode(dynamic, damaged);
        if (compiled.isPresent()) {
          assertTrue(accepted == accepts(compiled.get(), damaged), "both codecs agree on what is valid");
        }
        refused += accepted ? 0 : 1;
      }
      assertTrue(refused > 0, each.info().type());
    }
  }

  private static List<BagReader.Recorded> oneOfEachType(String bag) {
    Map<String, BagReader.Recorded> byType = new LinkedHashMap<>();
    BagReader.read(SharedData.bag(bag)).forEach(m -> byType.putIfAbsent(m.info().type(), m));
    return List.copyOf(byType.values());
  }

  private boolean tryDecode(DynamicCodec codec, byte[] bytes) {
    try {
      visit(new RosValue.Nested(codec.decode(ByteBuffer.wrap(bytes))));
      return true;
    } catch (MessageException e) {
      return false;
    }
  }

  private static void visit(RosValue value) {
    switch (value) {
      case RosValue.Nested n -> fields(n.value());
      case RosValue.Messages m -> m.values().stream().limit(50).forEach(MutatedMessagesTest::fields);
      case RosValue.Texts t -> assertTrue(String.join("", t.values()).length() >= 0);
      case RosValue.Numbers n -> assertTrue(n.values().toDoubles().length == n.values().size());
      default -> {}
    }
  }

  private static void fields(DynamicMessage message) {
    message.fields().forEach(f -> visit(message.field(f.name()).orElseThrow()));
  }

  private static boolean accepts(RecordCodec<?> codec, byte[] bytes) {
    try {
      codec.decode(ByteBuffer.wrap(bytes));
      return true;
    } catch (MessageException e) {
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
    if (bytes.length >= Integer.BYTES) {
      int at = random.nextInt(Math.min(200, bytes.length - Integer.BYTES + 1));
      ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).putInt(at, EVIL[random.nextInt(EVIL.length)]);
    }
    return bytes;
  }

  private byte[] withFlippedBits(byte[] bytes) {
    for (int i = 0; i < 4; i++) {
      bytes[random.nextInt(Math.min(200, bytes.length))] ^= (byte) (1 << random.nextInt(8));
    }
    return bytes;
  }

  @Test
  @Timeout(1_200)
  void damagedDefinitionsAreRefusedOrRead() throws Exception {
    int refused = 0;
    for (BagReader.Recorded each : oneOfEachType("sena_loop.bag")) {
      String text = each.info().definition();
      for (Effort effort = Effort.of(ROUNDS, LONG); effort.goesOn();) {
        refused += reads(each.info().type(), damage(text)) ? 0 : 1;
      }
    }
    assertTrue(refused > ROUNDS, "most damages matter");
  }

  private String damage(String text) {
    int from = random.nextInt(text.length());
    int to = Math.min(text.length(), from + random.nextInt(40));
    String piece = text.substring(from, to);
    return switch (random.nextInt(3)) {
      case 0 -> text.substring(0, from) + text.substring(to);
      case 1 -> text.substring(0, to) + piece + text.substring(to);
      default -> text.substring(0, from) + (char) random.nextInt(32, 127) + text.substring(from);
    };
  }

  private static boolean reads(String type, String text) {
    try {
      MessageSchema.parse(type, text);
      return true;
    } catch (DefinitionException e) {
      return false;
    }
  }
}
