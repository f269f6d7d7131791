package org.robotui.entity.pointcloud.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.util.Arrays;
import java.util.Optional;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.junit.jupiter.api.Test;
import org.robotui.gl.shape.PointSet;
import org.robotui.gl.shape.PointSet.Unit;

class SampleTest {
  /** Points in a row, each with its number as coordinate and as colour. */
  private static PointSet row(int count) {
    float[] xyz = new float[3 * count];
    ByteBuffer rgba = ByteBuffer.allocate(Integer.BYTES * count);
    for (int i = 0; i < count; i++) {
      xyz[3 * i] = i;
      rgba.putInt(i);
    }
    return PointSet.of(FloatBuffer.wrap(xyz), Optional.of(rgba.flip()), 1, Unit.PIXELS);
  }

  @ParameterizedTest
  @ValueSource(ints = {100_000, 131_072, 640 * 480, 999_983})
  void anyNthOfItIsSpreadOverTheWhole(int count) {
    PointSet sample = Sample.in(row(count)).sample().orElseThrow();
    for (int every : new int[]{1, 3, 16, 64}) {
      int[] tenths = new int[10];
      for (int i = 0; i < sample.elements(); i += every) {
        tenths[(int) (sample.xyz().get(3 * i) * 10 / count)]++;
      }
      int fair = Math.ceilDiv(sample.elements(), every) / 10;
      assertTrue(Arrays.stream(tenths).allMatch(t -> Math.abs(t - fair) <= 0.1 * fair + 2),
          every + ": " + Arrays.toString(tenths));
    }
  }

  @Test
  void colourAndPlaceAreOfTheSamePoint() {
    PointSet sample = Sample.in(row(200_000)).sample().orElseThrow();
    assertEquals(25_000, sample.elements());
    for (int i = 0; i < sample.elements(); i++) {
      assertEquals(sample.xyz().get(3 * i), sample.rgba().orElseThrow().getInt(Integer.BYTES * i));
    }
  }

  @Test
  void withoutColoursThereAreNoneInTheSample() {
    PointSet plain = PointSet.of(FloatBuffer.allocate(3 * Sample.LARGE), Optional.empty(), 1, Unit.PIXELS);
    assertTrue(Sample.in(plain).sample().orElseThrow().rgba().isEmpty());
  }

  @Test
  void aSmallCloudIsLeftAsItIs() {
    PointSet small = row(Sample.LARGE - 1);
    assertSame(small, Sample.in(small));
  }
}
