package org.robotui.recording.internal.mcap;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.ByteBuffer;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The sum of pieces is that of all bytes. */
class JoinedSumTest {
  private static final int LENGTH = 100_000;

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2, 255, 4096, LENGTH - 1, LENGTH})
  void is_that_of_all_bytes(int cut) {
    byte[] bytes = new byte[LENGTH];
    new Random(7).nextBytes(bytes);
    int first = SummedBytes.of(ByteBuffer.wrap(bytes, 0, cut)).sum();
    int second = SummedBytes.of(ByteBuffer.wrap(bytes, cut, LENGTH - cut)).sum();
    assertEquals(SummedBytes.of(ByteBuffer.wrap(bytes)).sum(), JoinedSum.of(first, second, LENGTH - cut));
  }
}
