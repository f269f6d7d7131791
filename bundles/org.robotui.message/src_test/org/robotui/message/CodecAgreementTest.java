package org.robotui.message;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.stream.Stream;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Compiled codecs and the codec that works from the definition agree on every byte. */
class CodecAgreementTest {

  private static final int ROUNDS = 20;

  static Stream<RecordCodec<?>> codecs() throws Exception {
    return ShippedRecords.codecs().values().stream();
  }

  @ParameterizedTest
  @MethodSource("codecs")
  void randomMessagesSurviveBothCodecs(RecordCodec<?> codec) throws Exception {
    DynamicCodec dynamic = new DynamicCodec(ShippedDefinitions.schema(codec.info().type()));
    RandomTrees trees = new RandomTrees(new SplittableRandom(7));
    Layout layout = ShippedDefinitions.schema(codec.info().type()).layout();
    for (int round = 0; round < ROUNDS; round++) {
      DynamicMessage message = dynamic.build(trees.tree(layout));
      byte[] bytes = array(message.bytes());
      byte[] again = reencode(codec, bytes);
      assertArrayEquals(bytes, again, codec.info().type());
      assertTrue(message.equals(dynamic.decode(ByteBuffer.wrap(again))));
    }
  }

  @ParameterizedTest
  @MethodSource("codecs")
  void everyTruncatedOrOverlongMessageIsRefusedByBoth(RecordCodec<?> codec) throws Exception {
    DynamicCodec dynamic = new DynamicCodec(ShippedDefinitions.schema(codec.info().type()));
    Layout layout = ShippedDefinitions.schema(codec.info().type()).layout();
    byte[] bytes = array(dynamic.build(new RandomTrees(new SplittableRandom(3)).tree(layout)).bytes());
    for (int length = 0; length <= bytes.length + 1; length++) {
      ByteBuffer cut = ByteBuffer.wrap(Arrays.copyOf(bytes, length));
      if (length != bytes.length) {
        assertThrows(MessageException.class, () -> codec.decode(cut.duplicate()));
        assertThrows(MessageException.class, () -> dynamic.decode(cut.duplicate()));
      }
    }
  }

  private static <T extends Record> byte[] reencode(RecordCodec<T> codec, byte[] bytes) throws MessageException {
    MessageWriter out = new MessageWriter();
    codec.encode(codec.decode(ByteBuffer.wrap(bytes)), out);
    return out.toByteArray();
  }

  private static byte[] array(ByteBuffer buffer) {
    byte[] bytes = new byte[buffer.remaining()];
    buffer.get(bytes);
    return bytes;
  }
}
