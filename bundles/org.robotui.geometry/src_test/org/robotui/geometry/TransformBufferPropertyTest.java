package org.robotui.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Random trees, compared with transforms composed by hand. */
class TransformBufferPropertyTest {
  private static final int FRAMES = 30;

  private final SplittableRandom random = new SplittableRandom(42);

  private RigidTransform transform() {
    Vector3 translation =
        new Vector3(random.nextDouble(-5, 5), random.nextDouble(-5, 5), random.nextDouble(-5, 5));
    return new RigidTransform(translation, Quaternion.fromRollPitchYaw(
        random.nextDouble(-3, 3), random.nextDouble(-1.5, 1.5), random.nextDouble(-3, 3)));
  }

  private static void assertClose(RigidTransform expected, RigidTransform actual) {
    for (Vector3 p : List.of(Vector3.ZERO, new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1))) {
      double error = expected.apply(p).minus(actual.apply(p)).norm();
      assertTrue(error < 1e-9, "a point is off by " + error);
    }
  }

  @Test
  void everyPairOfARandomTreeIsTheCompositionOfItsEdges() {
    for (int round = 0; round < 20; round++) {
      TransformBuffer<Integer> buffer = new TransformBuffer<>();
      List<RigidTransform> rootFrom = new ArrayList<>(List.of(RigidTransform.IDENTITY));
      for (int frame = 1; frame < FRAMES; frame++) {
        int parent = random.nextInt(frame);
        RigidTransform before = transform();
        RigidTransform after = transform();
        if (random.nextInt(4) == 0) {
          buffer.putStatic(parent, frame, before, "test");
          rootFrom.add(rootFrom.get(parent).times(before));
        } else {
          buffer.put(parent, frame, 1000, before, "test");
          buffer.put(parent, frame, 2000, after, "test");
          rootFrom.add(rootFrom.get(parent).times(before.interpolate(after, 0.25)));
        }
      }
      comparePairs(buffer, rootFrom);
    }
  }

  private void comparePairs(TransformBuffer<Integer> buffer, List<RigidTransform> rootFrom) {
    for (int target = 0; target < FRAMES; target++) {
      for (int source = 0; source < FRAMES; source++) {
        RigidTransform expected = rootFrom.get(target).inverse().times(rootFrom.get(source));
        assertClose(expected, buffer.lookup(target, source, 1250).transform().orElseThrow());
      }
    }
  }

  @Test
  void theBufferStaysATreeWhateverIsPut() {
    TransformBuffer<Integer> buffer = new TransformBuffer<>();
    for (int i = 0; i < 5000; i++) {
      buffer.put(random.nextInt(12), random.nextInt(12), random.nextLong(1000), transform(), "test");
      for (int frame : buffer.frames()) {
        int steps = 0;
        for (int f = frame; buffer.parentOf(f).isPresent(); f = buffer.parentOf(f).orElseThrow()) {
          assertTrue(++steps < 12, "a loop");
        }
      }
    }
    assertTrue(buffer.edges().size() > 5);
  }

  @Test
  @Timeout(60)
  void severalThreadsReadAndWriteAtOnce() throws Exception {
    TransformBuffer<String> buffer = new TransformBuffer<>(new TransformLimits(1000, 10, 100));
    buffer.put("odom", "base", 0, RigidTransform.IDENTITY, "test");
    Callable<Integer> writer = () -> {
      for (int i = 1; i <= 20_000; i++) {
        buffer.put("odom", "base", i, RigidTransform.planar(i, 0, 0), "test");
      }
      return 20_000;
    };
    Callable<Integer> reader = () -> {
      int found = 0;
      for (int i = 0; i < 20_000; i++) {
        if (buffer.lookupLatest("odom", "base") instanceof TransformLookup.Found<String> f) {
          assertEquals(f.stampNanos(), f.targetFromSource().translation().x());
          found++;
        }
      }
      return found;
    };
    try (ExecutorService threads = Executors.newFixedThreadPool(4)) {
      for (Future<Integer> each : threads.invokeAll(List.of(writer, reader, reader, reader))) {
        assertEquals(20_000, each.get());
      }
    }
  }
}
