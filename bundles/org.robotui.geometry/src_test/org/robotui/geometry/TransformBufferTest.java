package org.robotui.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import java.util.Set;

import org.junit.jupiter.api.Test;

class TransformBufferTest {
  private static final long SECOND = 1_000_000_000L;
  private static final RigidTransform AHEAD = RigidTransform.planar(1, 0, 0);

  private final TransformBuffer<String> buffer = new TransformBuffer<>(new TransformLimits(10 * SECOND, 5, 4));

  private TransformPut<String> put(String parent, String child, long stamp, double x) {
    return buffer.put(parent, child, stamp, RigidTransform.planar(x, 0, 0), "test");
  }

  private double x(TransformLookup<String> lookup) {
    return assertInstanceOf(TransformLookup.Found.class, lookup).targetFromSource().translation().x();
  }

  private static String reason(TransformPut<String> put) {
    return assertInstanceOf(TransformPut.Refused.class, put).reason();
  }

  @Test
  void positionsAreInterpolatedLinearly() {
    put("odom", "base", 10 * SECOND, 0);
    put("odom", "base", 12 * SECOND, 4);
    assertEquals(1, x(buffer.lookup("odom", "base", 10 * SECOND + SECOND / 2)), 1e-12);
    assertEquals(-1, x(buffer.lookup("base", "odom", 10 * SECOND + SECOND / 2)), 1e-12);
    assertEquals(4, x(buffer.lookup("odom", "base", 12 * SECOND)), 1e-12);
  }

  @Test
  void rotationsAreInterpolatedAlongTheShorterArc() {
    buffer.put("a", "b", 0, RigidTransform.planar(0, 0, 3), "t");
    buffer.put("a", "b", 2, RigidTransform.planar(0, 0, -3), "t");
    RigidTransform middle = buffer.lookup("a", "b", 1).transform().orElseThrow();
    assertEquals(Math.PI, Math.abs(middle.rotation().yaw()), 1e-9);
  }

  @Test
  void framesAreJoinedOverTheirCommonAncestor() {
    buffer.putStatic("base", "laser", RigidTransform.planar(1, 0, 0), "t");
    buffer.putStatic("base", "camera", RigidTransform.planar(0, 2, Math.PI / 2), "t");
    RigidTransform cameraFromLaser = buffer.lookupLatest("camera", "laser").transform().orElseThrow();
    Vector3 seen = cameraFromLaser.apply(Vector3.ZERO);
    assertEquals(-2, seen.x(), 1e-12);
    assertEquals(-1, seen.y(), 1e-12);
  }

  @Test
  void aFrameInItselfIsTheIdentityOnlyWhereItIsKnown() {
    put("a", "b", 5, 1);
    assertEquals(0, x(buffer.lookup("b", "b", 99)));
    assertEquals(0, x(buffer.lookupLatest("a", "a")));
    TransformLookup<String> unknown = buffer.lookup("c", "c", 5);
    assertEquals(new TransformLookup.UnknownFrame<>("c"), unknown);
    assertTrue(unknown.explanation().contains("frame c"), unknown.explanation());
    assertEquals(new TransformLookup.UnknownFrame<>("d"), buffer.lookup("a", "d", 5));
  }

  @Test
  void theMissingLinkBetweenTwoTreesIsNamed() {
    put("odom", "base", 5, 1);
    put("map", "goal", 5, 1);
    TransformLookup<String> lookup = buffer.lookup("goal", "base", 5);
    assertEquals(new TransformLookup.Disconnected<>("goal", "map", "base", "odom"), lookup);
    assertTrue(lookup.explanation().contains("a transform between map and odom is missing"), lookup.explanation());
  }

  @Test
  void nothingIsExtrapolated() {
    put("odom", "base", 5 * SECOND, 1);
    put("odom", "base", 6 * SECOND, 1);
    TransformLookup<String> old = buffer.lookup("odom", "base", 4 * SECOND);
    assertEquals(new TransformLookup.TooOld<>("odom", "base", 5 * SECOND, 4 * SECOND), old);
    assertTrue(old.explanation().contains("odom -> base"), old.explanation());
    TransformLookup<String> young = buffer.lookup("base", "odom", 8 * SECOND);
    assertEquals(new TransformLookup.TooNew<>("odom", "base", 6 * SECOND, 8 * SECOND), young);
    assertEquals("the transform odom -> base is 2.00 s behind the asked time", young.explanation());
  }

  @Test
  void theLatestCommonTimeIsThatOfTheEdgeThatEndsFirst() {
    put("map", "odom", 5, 10);
    put("map", "odom", 9, 20);
    put("odom", "base", 3, 1);
    put("odom", "base", 7, 2);
    buffer.putStatic("base", "laser", AHEAD, "t");
    TransformLookup.Found<String> found = (TransformLookup.Found<String>) buffer.lookupLatest("map", "laser");
    assertEquals(7, found.stampNanos());
    assertEquals(15 + 2 + 1, x(found), 1e-12);
  }

  @Test
  void edgesThatNeverOverlapHaveNoCommonTime() {
    put("map", "odom", 5, 10);
    put("odom", "base", 7, 2);
    TransformLookup<String> none = buffer.lookupLatest("map", "base");
    assertEquals(new TransformLookup.NoCommonTime<>("map", "base"), none);
    assertTrue(none.explanation().contains("no time in common"));
  }

  @Test
  void anEdgeForgetsWhatIsOlderThanTheCacheOrBeyondItsSize() {
    for (int i = 0; i <= 5; i++) {
      put("a", "b", i * SECOND, i);
    }
    FrameEdge<String> edge = buffer.edges().getFirst();
    assertEquals(4, edge.samples());
    assertEquals(2 * SECOND, edge.oldestNanos());
    put("a", "b", 14 * SECOND, 0);
    assertEquals(4 * SECOND, buffer.edges().getFirst().oldestNanos());
    assertTrue(reason(put("a", "b", 3 * SECOND, 0)).contains("older than what is remembered"));
    put("a", "b", 40 * SECOND, 0);
    assertEquals(1, buffer.edges().getFirst().samples());
  }

  @Test
  void aSampleThatComesLateIsSortedIn() {
    put("a", "b", 4, 4);
    put("a", "b", 2, 0);
    put("a", "b", 3, 9);
    assertEquals(9, x(buffer.lookup("a", "b", 3)));
    assertEquals(4, buffer.edges().getFirst().newestNanos());
  }

  @Test
  void aNewParentMovesTheFrameAndForgetsItsHistory() {
    put("a", "c", 1, 1);
    assertEquals(new TransformPut.Accepted<String>(Optional.empty()), put("a", "b", 1, 1));
    assertEquals(new TransformPut.Accepted<>(Optional.of("a")), put("b", "c", 2, 1));
    assertEquals(Optional.of("b"), buffer.parentOf("c"));
    assertInstanceOf(TransformLookup.TooOld.class, buffer.lookup("b", "c", 1));
    assertEquals(Optional.empty(), buffer.parentOf("a"));
  }

  @Test
  void aStaticTransformReplacesAMovingOneAndBack() {
    put("a", "b", 5, 1);
    buffer.putStatic("a", "b", RigidTransform.planar(7, 0, 0), "t");
    assertEquals(7, x(buffer.lookup("a", "b", 123456)));
    put("a", "b", 6, 2);
    assertInstanceOf(TransformLookup.TooOld.class, buffer.lookup("a", "b", 5));
  }

  @Test
  void loopsAreRefused() {
    put("a", "b", 1, 1);
    put("b", "c", 1, 1);
    assertEquals("the transform 'c' -> 'a' would close a loop: 'c' is below 'a'", reason(put("c", "a", 1, 1)));
    assertEquals("the transform 'b' -> 'b' names one frame twice", reason(put("b", "b", 1, 1)));
    assertEquals(Optional.empty(), buffer.parentOf("a"));
  }

  @Test
  void malformedTransformsAreRefused() {
    RigidTransform zero = new RigidTransform(Vector3.ZERO, new Quaternion(0, 0, 0, 0));
    assertTrue(reason(buffer.put("a", "b", 1, zero, "t")).contains("has a rotation of length 0.0 instead of 1"));
    RigidTransform nan = new RigidTransform(new Vector3(Double.NaN, 0, 0), Quaternion.IDENTITY);
    assertTrue(reason(buffer.put("a", "b", 1, nan, "t")).contains("not finite"));
    RigidTransform nanTurn = new RigidTransform(Vector3.ZERO, new Quaternion(0, Double.NaN, 0, 1));
    assertTrue(reason(buffer.putStatic("a", "b", nanTurn, "t")).contains("rotation of length NaN"));
    assertTrue(reason(buffer.put("a", "b", -1, AHEAD, "t")).contains("negative"));
    assertEquals(Set.of(), buffer.frames());
  }

  @Test
  void aRotationThatIsNearlyOfUnitLengthIsScaled() {
    buffer.put("a", "b", 1, new RigidTransform(Vector3.ZERO, new Quaternion(0, 0, 0, 1.005)), "t");
    assertEquals(Quaternion.IDENTITY, buffer.lookup("a", "b", 1).transform().orElseThrow().rotation());
  }

  @Test
  void theNumberOfEdgesIsBounded() {
    for (int i = 0; i < 5; i++) {
      assertInstanceOf(TransformPut.Accepted.class, put("root", "f" + i, 1, 1));
    }
    assertTrue(reason(put("root", "one more", 1, 1)).contains("one more than the 5"));
    assertInstanceOf(TransformPut.Accepted.class, put("root", "f0", 2, 1));
  }

  @Test
  void aJumpOfTheClockForgetsAllButStaticTransforms() {
    put("odom", "base", 100 * SECOND, 1);
    buffer.putStatic("base", "laser", AHEAD, "t");
    buffer.clear();
    assertEquals(Set.of("base", "laser"), buffer.frames());
    assertInstanceOf(TransformPut.Accepted.class, put("odom", "base", 3 * SECOND, 1));
    assertEquals(2, x(buffer.lookup("odom", "laser", 3 * SECOND)));
  }
}
