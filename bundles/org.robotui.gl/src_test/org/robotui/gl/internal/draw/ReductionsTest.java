package org.robotui.gl.internal.draw;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.robotui.gl.internal.splat.Facets;
import org.robotui.gl.shape.Meshes;
import org.robotui.gl.shape.TriangleMesh;

class ReductionsTest {
  private static final double NEAR = 0.001;
  private static final double FAR = 0.3;

  private final ExecutorService background = Executors.newSingleThreadExecutor();
  private final TriangleMesh ball = Meshes.sphere();
  private final Reductions reductions = new Reductions(ball, Levels.of(ball));

  @AfterEach
  void end() {
    background.shutdownNow();
  }

  /** Waits until all is done that was asked for before. */
  private void await() throws Exception {
    background.submit(() -> {}).get(60, TimeUnit.SECONDS);
  }

  private Facets made(double metres) throws Exception {
    reductions.within(metres, background);
    await();
    return reductions.within(metres, background).orElseThrow();
  }

  @Test
  void thereIsNoneUntilItIsMadeAndFromFartherAwayItHasFewerTriangles() throws Exception {
    CountDownLatch busy = new CountDownLatch(1);
    background.submit(() -> busy.await(60, TimeUnit.SECONDS));
    assertEquals(Optional.empty(), reductions.within(FAR, background));
    busy.countDown();
    Facets far = made(FAR);
    assertTrue(far.count() < made(NEAR).count(), () -> far.count() + " triangles");
    assertTrue(far.count() >= 4, "a body is left");
  }

  @Test
  void oneOctaveIsMadeOnce() throws Exception {
    assertEquals(made(0.017), made(0.03));
  }

  @Test
  void anOctaveThatTheCameraHasLeftIsNotMade() throws Exception {
    CountDownLatch busy = new CountDownLatch(1);
    background.submit(() -> busy.await(60, TimeUnit.SECONDS));
    reductions.within(FAR, background);
    reductions.within(NEAR, background);
    busy.countDown();
    await();
    assertEquals(Optional.empty(), reductions.within(FAR, background));
  }

  @Test
  void whatReachesFarBeyondThePictureIsDrawnAsItIs() throws Exception {
    reductions.within(1e-9, background);
    reductions.within(0, background);
    reductions.within(Double.NaN, background);
    await();
    assertEquals(Optional.empty(), reductions.within(1e-9, background));
  }

  @Test
  void aMeshWithoutCornersHasNone() {
    TriangleMesh none = TriangleMesh.of(FloatBuffer.allocate(0), Optional.empty(), IntBuffer.allocate(0));
    assertEquals(Optional.empty(), new Reductions(none, Levels.of(none)).within(1, background));
  }
}
