package org.robotui.recording.internal.codec;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Random;
import net.jpountz.lz4.LZ4FrameOutputStream;
import net.jpountz.xxhash.XXHashFactory;
import org.junit.jupiter.api.Test;
import org.robotui.testkit.ByteMutator;

class Lz4FramesTest {

  private static final int LINKED = 0x40;
  private static final int ALONE = 0x60;

  private final Lz4Frames frames = new Lz4Frames();

  @Test
  void have_blocks_that_refer_to_those_before() throws IOException {
    // the second block: eight bytes from eight bytes before, then a literal
    byte[] frame = frame(LINKED, stored("abcdefgh"), packed(0x04, 8, 0, 0x10, 'z'));
    assertEquals("abcdefghabcdefghz", decoded(frame, 100));
    IOException refused = assertThrows(IOException.class, () -> decoded(frame, 16));
    assertTrue(refused.getMessage().startsWith("a block "), refused.getMessage());
  }

  @Test
  void repeat_what_is_nearer_than_it_is_long() throws IOException {
    assertEquals("ab" + "ababababababababababa" + "z",
        decoded(frame(LINKED, stored("ab"), packed(0x0f, 2, 0, 2, 0x10, 'z')), 100));
  }

  @Test
  void with_blocks_that_stand_alone_may_not_refer_to_others() {
    byte[] frame = frame(ALONE, stored("abcdefgh"), packed(0x04, 8, 0, 0x10, 'z'));
    assertThrows(RuntimeException.class, () -> decoded(frame, 100));
  }

  @Test
  void may_not_refer_to_what_lies_before_them() {
    byte[] first = frame(LINKED, stored("abcdefgh"));
    byte[] second = frame(LINKED, packed(0x04, 8, 0, 0x10, 'z'));
    byte[] both = Arrays.copyOf(first, first.length + second.length);
    System.arraycopy(second, 0, both, first.length, second.length);
    IOException refused = assertThrows(IOException.class, () -> decoded(both, 100));
    assertEquals("a block refers to what is not there", refused.getMessage());
  }

  @Test
  void are_as_the_library_writes_them_and_checked() throws IOException {
    byte[] plain = new byte[300_000];
    Random random = new Random(3);
    for (int i = 0; i < plain.length; i += 1 + random.nextInt(5)) {
      plain[i] = (byte) random.nextInt(20);
    }
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    try (LZ4FrameOutputStream frame = new LZ4FrameOutputStream(out, LZ4FrameOutputStream.BLOCKSIZE.SIZE_64KB,
        LZ4FrameOutputStream.FLG.Bits.BLOCK_INDEPENDENCE, LZ4FrameOutputStream.FLG.Bits.BLOCK_CHECKSUM,
        LZ4FrameOutputStream.FLG.Bits.CONTENT_CHECKSUM)) {
      frame.write(plain);
    }
    byte[] frame = out.toByteArray();
    GrowingBytes all = new GrowingBytes(plain.length, 10);
    frames.decode(frame, 0, frame.length, all);
    assertArrayEquals(plain, Arrays.copyOf(all.array(), all.length()));

    ByteMutator mutator = new ByteMutator(8);
    int refused = 0;
    for (int i = 0; i < 500; i++) {
      byte[] damaged = mutator.mutate(frame);
      try {
        frames.decode(damaged, 0, damaged.length, new GrowingBytes(plain.length, 10));
      } catch (IOException | RuntimeException e) {
        refused++;
      }
    }
    assertTrue(refused > 400, refused + " of 500 were refused");
  }

  private String decoded(byte[] frame, int limit) throws IOException {
    GrowingBytes out = new GrowingBytes(limit, 4);
    frames.decode(frame, 0, frame.length, out);
    return new String(out.array(), 0, out.length(), StandardCharsets.US_ASCII);
  }

  private static byte[] stored(String text) {
    byte[] bytes = text.getBytes(StandardCharsets.US_ASCII);
    return ByteBuffer.allocate(4 + bytes.length).order(ByteOrder.LITTLE_ENDIAN).putInt(bytes.length | 0x8000_0000)
        .put(bytes).array();
  }

  private static byte[] packed(int... bytes) {
    ByteBuffer block = ByteBuffer.allocate(4 + bytes.length).order(ByteOrder.LITTLE_ENDIAN).putInt(bytes.length);
    Arrays.stream(bytes).forEach(value -> block.put((byte) value));
    return block.array();
  }

  private static byte[] frame(int flags, byte[]... blocks) {
    byte[] descriptor = {(byte) flags, 0x40};
    int sum = XXHashFactory.safeInstance().hash32().hash(descriptor, 0, 2, 0) >>> 8;
    ByteBuffer frame = ByteBuffer.allocate(1000).order(ByteOrder.LITTLE_ENDIAN).putInt(0x184D2204).put(descriptor)
        .put((byte) sum);
    Arrays.stream(blocks).forEach(frame::put);
    frame.putInt(0);
    return Arrays.copyOf(frame.array(), frame.position());
  }
}
