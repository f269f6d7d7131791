package org.robotui.carmen;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robotui.carmen.CarmenCaptures.Told;
import org.robotui.carmen.format.FormatText;
import org.robotui.carmen.format.FormatTree;
import org.robotui.carmen.format.IpcFormat;
import org.robotui.carmen.format.IpcFormatException;
import org.robotui.carmen.message.IpcForm;
import org.robotui.carmen.message.IpcForms;
import org.robotui.carmen.wire.IpcFraming;
import org.robotui.testkit.Effort;

/** Damaged recordings lead to the declared exceptions only, quickly and without large allocations. */
class MutatedFramesTest {

  private static final int ROUNDS = 400;
  private static final Duration LONG = Duration.ofSeconds(20);
  private static final int[] EVIL = {-1, Integer.MAX_VALUE, Integer.MIN_VALUE, 1 << 28, 1 << 16, 0, 1};
  /** Of a message: what is damaged behind that is but another scan. */
  private static final int FRONT = 300;

  private final SplittableRandom random = new SplittableRandom(2026 + Effort.seed());

  @ParameterizedTest
  @ValueSource(strings = {"base_client", "base_map", "base_simulator", "localize_localize", "direct_client"})
  @Timeout(1_200)
  void damagedMessagesAreRefusedOrRead(String connection) throws IOException {
    Set<String> seen = new HashSet<>();
    List<Told> kinds = CarmenCaptures.all(connection).stream()
        .filter(t -> t.frame().body().hasRemaining() && seen.add(t.form().name())).toList();
    int refused = 0;
    for (Effort effort = Effort.of(ROUNDS, LONG); effort.goesOn();) {
      Told told = kinds.get(random.nextInt(kinds.size()));
      ByteOrder order = random.nextInt(4) == 0 ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN;
      refused += reads(told, ByteBuffer.wrap(damage(told.frame().body())).order(order)) ? 0 : 1;
    }
    assertTrue(refused > 0, "some damages matter");
  }

  private static boolean reads(Told told, ByteBuffer body) {
    try {
      assertTrue(!(told.bare() ? told.form().readBare(body) : told.form().read(body)).toString().isEmpty());
      return true;
    } catch (IpcFormatException e) {
      return false;
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"base_client", "localize_client", "direct_client"})
  @Timeout(1_200)
  void damagedStreamsEndWithAnErrorOrTheirEnd(String connection) throws IOException {
    byte[] whole = Arrays.copyOf(CarmenCaptures.bytes(connection + ".s2c.bin"), 10_000);
    int refused = 0;
    for (Effort effort = Effort.of(ROUNDS / 4, LONG); effort.goesOn();) {
      ByteArrayInputStream in = new ByteArrayInputStream(damage(ByteBuffer.wrap(whole)));
      in.skip(4);
      refused += readsToTheEnd(in) ? 0 : 1;
    }
    assertTrue(refused > 0, "some damages matter");
  }

  private static boolean readsToTheEnd(ByteArrayInputStream in) throws IOException {
    try {
      while (in.available() > 0) {
        IpcFraming.read(in);
      }
      return true;
    } catch (EOFException | IpcFormatException e) {
      return false;
    }
  }

  @Test
  @Timeout(1_200)
  void damagedFormatsAreRefusedOrRead() {
    List<IpcForm> forms = IpcForms.carmen().names().stream().map(IpcForms.carmen()::get).toList();
    int refused = 0;
    for (Effort effort = Effort.of(ROUNDS, LONG); effort.goesOn();) {
      IpcFormat format = forms.get(random.nextInt(forms.size())).format();
      byte[] text = damage(ByteBuffer.wrap(format.toString().getBytes(StandardCharsets.ISO_8859_1)));
      byte[] tree = damage(ByteBuffer.wrap(FormatTree.bytes(format, ByteOrder.LITTLE_ENDIAN)));
      refused += parses(new String(text, StandardCharsets.ISO_8859_1)) && reads(tree) ? 0 : 1;
    }
    assertTrue(refused > 0, "some damages matter");
  }

  private boolean parses(String text) {
    try {
      return readsMessages(FormatText.parse(text));
    } catch (IpcFormatException e) {
      return false;
    }
  }

  private boolean reads(byte[] tree) {
    try {
      return readsMessages(FormatTree.read(ByteBuffer.wrap(tree).order(ByteOrder.LITTLE_ENDIAN)));
    } catch (IpcFormatException e) {
      return false;
    }
  }

  /** A format that was read may still be one by which nothing sensible can be sent. */
  private boolean readsMessages(IpcFormat format) throws IpcFormatException {
    byte[] body = new byte[64];
    random.nextBytes(body);
    try {
      IpcForm.numbered("any", format).readBare(ByteBuffer.wrap(body));
      return true;
    } catch (IpcFormatException e) {
      return true;
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
      ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).putInt(random.nextInt(words) * Integer.BYTES,
          EVIL[random.nextInt(EVIL.length)]);
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
