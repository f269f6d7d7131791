package org.robotui.smartsoft;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robotui.message.MessageException;
import org.robotui.smartsoft.naming.ServiceAddress;
import org.robotui.smartsoft.naming.ServiceName;
import org.robotui.smartsoft.object.CommType;
import org.robotui.smartsoft.object.CommTypes;
import org.robotui.smartsoft.wire.SmartFraming;
import org.robotui.smartsoft.wire.SmartSoftException;
import org.robotui.testkit.Effort;

/** Damaged recordings lead to the declared exceptions only, quickly and without large allocations. */
class SmartMutationsTest {

  private static final int ROUNDS = 400;
  private static final Duration LONG = Duration.ofSeconds(20);
  private static final int[] EVIL = {-1, Integer.MAX_VALUE, Integer.MIN_VALUE, 1 << 28, 1 << 16, 0, 1};

  private final SplittableRandom random = new SplittableRandom(2026 + Effort.seed());

  @ParameterizedTest
  @ValueSource(strings = {"push.s2c", "event_interval.c2s", "send_b1.c2s", "ns_send_client.s2c"})
  @Timeout(1_200)
  void damaged_streams_end_with_an_error_or_their_end(String file) {
    byte[] whole = SmartCaptures.bytes(file);
    int refused = 0;
    for (Effort effort = Effort.of(ROUNDS, LONG); effort.goesOn();) {
      refused += readsToTheEnd(new ByteArrayInputStream(damage(whole))) ? 0 : 1;
    }
    assertTrue(refused > 0, "some damages matter");
  }

  private static boolean readsToTheEnd(ByteArrayInputStream in) {
    try {
      while (in.available() > 0) {
        new SmartFraming().read(in);
      }
      return true;
    } catch (IOException e) {
      return false;
    }
  }

  @Test
  @Timeout(1_200)
  void damaged_parts_are_refused_or_read() {
    List<KnownParts.Part> parts = SmartCaptures.files()
        .flatMap(file -> SmartCaptures.frames(file).stream().limit(40)
            .flatMap(frame -> Stream.concat(KnownParts.pattern(file, frame).stream(),
                KnownParts.object(file, frame).stream())))
        .toList();
    int refused = 0;
    for (Effort effort = Effort.of(4 * ROUNDS, LONG); effort.goesOn();) {
      KnownParts.Part part = parts.get(random.nextInt(parts.size()));
      byte[] bytes = new byte[part.bytes().remaining()];
      part.bytes().duplicate().get(bytes);
      refused += reads(part.type(), damage(bytes)) ? 0 : 1;
    }
    assertTrue(refused > 0, "some damages matter");
  }

  /** Objects that were never recorded, made by us. */
  @ParameterizedTest
  @ValueSource(strings = {"CommBasicObjects::CommMobileLaserScan", "CommNavigationObjects::CommGridMap",
      "CommLocalizationObjects::CommAmclVisualizationInfo", "CommParameter::CommParameterRequest",
      "SmartACE::smartStateResponse", "CommBasicObjects::CommIOValues"})
  @Timeout(1_200)
  void damaged_objects_are_refused_or_read(String name) throws MessageException {
    CommType type = CommTypes.shipped().get(name);
    ByteBuffer bytes = type.bytes(Map.of());
    byte[] whole = new byte[bytes.remaining()];
    bytes.get(whole);
    int refused = 0;
    for (Effort effort = Effort.of(ROUNDS, LONG); effort.goesOn();) {
      refused += reads(type, damage(whole)) ? 0 : 1;
    }
    assertTrue(refused > 0, "some damages matter");
  }

  private boolean reads(CommType type, byte[] bytes) {
    ByteOrder order = random.nextInt(4) == 0 ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN;
    try {
      return !type.read(ByteBuffer.wrap(bytes).order(order)).toString().isEmpty();
    } catch (MessageException e) {
      return false;
    }
  }

  @Test
  void damaged_names_and_addresses_are_refused_or_read() {
    byte[] name = "<base><Push><state><CommBasicObjects::CommBaseState>".getBytes(StandardCharsets.UTF_8);
    byte[] address = "127.0.0.1:37319#e6eb50ee-e565".getBytes(StandardCharsets.UTF_8);
    int refused = 0;
    for (Effort effort = Effort.of(ROUNDS, LONG); effort.goesOn();) {
      refused += ServiceName.parse(new String(damage(name), StandardCharsets.UTF_8)).isPresent() ? 0 : 1;
      refused += isAddress(new String(damage(address), StandardCharsets.UTF_8)) ? 0 : 1;
    }
    assertTrue(refused > 0, "some damages matter");
  }

  private static boolean isAddress(String written) {
    try {
      return ServiceAddress.parse(written).at().port() > 0;
    } catch (SmartSoftException e) {
      return false;
    }
  }

  private byte[] damage(byte[] original) {
    byte[] bytes = original.clone();
    return switch (random.nextInt(4)) {
      case 0 -> Arrays.copyOf(bytes, random.nextInt(bytes.length));
      case 1 -> Arrays.copyOf(bytes, bytes.length + 1 + random.nextInt(16));
      case 2 -> withEvilLength(bytes);
      default -> withFlippedBits(bytes);
    };
  }

  private byte[] withEvilLength(byte[] bytes) {
    if (bytes.length >= Integer.BYTES) {
      ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).putInt(
          random.nextInt(bytes.length / Integer.BYTES) * Integer.BYTES, EVIL[random.nextInt(EVIL.length)]);
    }
    return bytes;
  }

  private byte[] withFlippedBits(byte[] bytes) {
    for (int i = 0; i < 4; i++) {
      bytes[random.nextInt(bytes.length)] ^= (byte) (1 << random.nextInt(8));
    }
    return bytes;
  }
}
