package org.robotui.gl.shape;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.FloatBuffer;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.gl.shape.PointSet.Unit;

class PointSetTest {
  private static PointSet points(int count) {
    return PointSet.of(FloatBuffer.allocate(3 * count), Optional.empty(), 1, Unit.PIXELS);
  }

  private static PointSet sampled(int count, int few) {
    PointSet all = points(count);
    return new PointSet(all.xyz(), all.rgba(), all.size(), all.unit(), all.style(), all.bounds(),
        Optional.of(points(few)));
  }

  @Test
  void allAreDrawnWhereAllAreWanted() {
    PointSet set = sampled(8000, 1000);
    assertSame(set, set.part(1).points());
    assertEquals(1, set.part(1).every());
  }

  @Test
  void theSampleStandsForAllWhereItIsLargeEnough() {
    PointSet set = sampled(8000, 1000);
    for (int every = 8; every < 200; every++) {
      PointSet.Part part = set.part(every);
      assertSame(set.sample().orElseThrow(), part.points());
      int drawn = Math.ceilDiv(part.points().elements(), part.every());
      assertTrue(drawn >= 8000 / every && drawn <= 2 * Math.ceilDiv(8000, every), every + ": " + drawn);
    }
  }

  @Test
  void whereTheSampleIsTooSmallAllAreThinned() {
    PointSet set = sampled(8000, 1000);
    assertEquals(new PointSet.Part(set, 7), set.part(7));
    assertEquals(new PointSet.Part(points(9), 5), points(9).part(5));
  }

  @Test
  void aSampleCountsAsMemory() {
    assertEquals(12 * 9000, sampled(8000, 1000).bytes());
  }
}
