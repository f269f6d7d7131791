package org.robotui.gl.internal.scene;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.robotui.gl.internal.scene.Stage.flat;
import static org.robotui.gl.internal.scene.Stage.request;
import static org.robotui.gl.internal.scene.Stage.square;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfEnvironmentVariable;
import org.robotui.gl.internal.context.NoOpenGl;
import org.robotui.gl.internal.gpu.GpuFailure;
import org.robotui.gl.render.RenderRequest;
import org.robotui.gl.render.Rendered;
import org.robotui.gl.render.Rendered.Figures;
import org.robotui.gl.shape.Label;
import org.robotui.gl.shape.LineSet;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.PointSet.Unit;
import org.robotui.gl.shape.TriangleMesh;

/** What is held on the graphics card, what is sent there, and what happens when it is lost. */
@EnabledIfEnvironmentVariable(named = "DISPLAY", matches = ".+", disabledReason = "no display: DISPLAY is not set")
class MemoryTest {
  private static final int RED = 0xff0000;

  private final Stage stage = new Stage();

  @AfterEach
  void close() throws InterruptedException {
    stage.close();
  }

  private Figures figures(Part... parts) throws Exception {
    return stage.picture(request(parts)).figures();
  }

  @Test
  void theSameShapeIsNotSentAgain() throws Exception {
    TriangleMesh mesh = square(0, 0.1f);
    assertEquals(mesh.bytes(), figures(flat("m", mesh, RED)).uploadedBytes());
    assertEquals(0, figures(flat("m", mesh, RED)).uploadedBytes());
    assertEquals(0, figures(flat("m", mesh, RED), flat("other", mesh, RED)).uploadedBytes());
  }

  @Test
  void anotherShapeOfTheSameSizeRefillsTheBuffers() throws Exception {
    Figures first = figures(flat("m", square(0, 0.1f), RED));
    Figures second = figures(flat("m", square(0, 0.2f), RED));
    assertEquals(first.uploadedBytes(), second.uploadedBytes());
    assertEquals(first.residentBytes(), second.residentBytes());
  }

  @Test
  void aLargerShapeGrowsThemByHalfMoreAndWhatIsMissingIsFreed() throws Exception {
    long empty = figures().residentBytes();
    figures(flat("l", LineSet.of(LineSet.Kind.STRIP, 1, new float[30]), RED));
    assertEquals(empty + 360,
        figures(flat("l", LineSet.of(LineSet.Kind.STRIP, 1, new float[60]), RED)).residentBytes());
    assertEquals(empty, figures().residentBytes());
  }

  @Test
  void aPartTooLargeIsNamedAndTheOthersAreThere() throws Exception {
    stage.picture(request());
    List<Part> parts = List.of(flat("large", LineSet.of(LineSet.Kind.STRIP, 1, new float[60]), RED),
        flat("small", square(0, 0.1f), RED));
    List<String> problems = stage.there(() -> {
      Residents residents = new Residents(stage.thread().present().orElseThrow(), 100);
      List<String> found = residents.follow(Map.of("display", parts));
      assertEquals(1, residents.all().size());
      residents.delete();
      return found;
    });
    assertEquals(1, problems.size());
    assertTrue(problems.getFirst().contains("large"), problems::getFirst);
  }

  @Test
  void aLostContextIsMadeAnewWithAllThatWasInIt() throws Exception {
    RenderRequest request =
        request(flat("m", square(0, 0.1f), RED), flat("t", new Label("word", 20, Unit.PIXELS), RED));
    int[] before = stage.picture(request).rgb();
    stage.there(() -> {
      stage.thread().dropContext();
      return true;
    });
    Rendered.Picture after = stage.picture(request);
    assertArrayEquals(before, after.rgb());
    assertTrue(after.figures().uploadedBytes() > 0);
  }

  @Test
  void afterSomeFailuresInARowThereIsNoOpenGlAndTheReasonIsSaid() throws Exception {
    stage.picture(request());
    NoOpenGl verdict = stage.there(() -> assertThrows(NoOpenGl.class, () -> stage.thread().with(gpu -> {
      throw new GpuFailure("the driver is broken");
    })));
    assertTrue(verdict.getMessage().contains("the driver is broken"), verdict::getMessage);
    assertFalse(verdict.remedy().isBlank());
    Rendered.Unavailable answer = assertInstanceOf(Rendered.Unavailable.class, stage.rendered(request()));
    assertEquals(verdict.getMessage(), answer.reason());
  }

  @Test
  void aClassThatIsMissingEndsNeitherTheThreadNorTheWait() throws Exception {
    stage.picture(request());
    NoOpenGl verdict = stage.there(() -> assertThrows(NoOpenGl.class, () -> stage.thread().with(gpu -> {
      throw new NoClassDefFoundError("com/jogamp/opengl/GL");
    })));
    assertTrue(verdict.getMessage().contains("com/jogamp/opengl/GL"), verdict::getMessage);
    assertInstanceOf(Rendered.Unavailable.class, stage.rendered(request()));
  }

  @Test
  void oneFailureIsMendedUnseen() throws Exception {
    stage.picture(request());
    int[] tries = new int[1];
    int needed = stage.there(() -> assertDoesNotThrow(() -> stage.thread().with(gpu -> {
      if (++tries[0] == 1) {
        throw new GpuFailure("once");
      }
      return tries[0];
    })));
    assertEquals(2, needed);
  }

  @Test
  void theNewestRequestWaitsAndTheOthersAreSkipped() throws Exception {
    CountDownLatch busy = new CountDownLatch(1);
    stage.thread().execute(() -> await(busy));
    var first = stage.renderer().render(request());
    var second = stage.renderer().render(request());
    var third = stage.renderer().render(request(flat("m", square(0, 0.1f), RED)));
    busy.countDown();
    assertInstanceOf(Rendered.Skipped.class, first.toCompletableFuture().get(60, TimeUnit.SECONDS));
    assertInstanceOf(Rendered.Skipped.class, second.toCompletableFuture().get(60, TimeUnit.SECONDS));
    assertInstanceOf(Rendered.Picture.class, third.toCompletableFuture().get(60, TimeUnit.SECONDS));
  }

  private static void await(CountDownLatch latch) {
    try {
      latch.await();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  @Test
  void aPictureIsGivenUpBetweenThePiecesOfACloud() throws Exception {
    stage.picture(request());
    RenderRequest many = request(flat("p", Stage.points(1, new float[3_000_000]), RED));
    AtomicInteger asked = new AtomicInteger();
    Rendered answer = stage.there(() -> {
      Scene scene =
          new Scene(stage.thread().present().orElseThrow(), new PixelShelf(), () -> asked.incrementAndGet() > 0);
      Rendered made = scene.render(many);
      scene.delete();
      return made;
    });
    assertInstanceOf(Rendered.Skipped.class, answer);
    assertEquals(2, asked.get(), "before the first piece, and at the end");
  }

  @Test
  void whatIsGivenUpIsSkippedAndTheNextIsDrawn() throws Exception {
    CountDownLatch busy = new CountDownLatch(1);
    stage.thread().execute(() -> await(busy));
    var first = stage.renderer().render(request());
    stage.renderer().giveUp();
    assertInstanceOf(Rendered.Skipped.class, first.toCompletableFuture().get(60, TimeUnit.SECONDS));
    busy.countDown();
    assertInstanceOf(Rendered.Picture.class, stage.rendered(request()));
  }

  @Test
  void aClosedRendererAnswersThatItIs() throws Exception {
    stage.renderer().close();
    assertInstanceOf(Rendered.Unavailable.class, stage.rendered(request()));
    assertEquals(Optional.empty(), stage.pick(request(), 1, 1));
  }

  @Test
  void pixelsThatAreHandedBackAreWrittenAnewAndOthersStay() throws Exception {
    Rendered.Picture kept = stage.picture(request(flat("m", square(0, 0.1f), RED)));
    Rendered.Picture lent = stage.picture(request());
    assertNotSame(kept.rgb(), lent.rgb());
    stage.renderer().recycle(lent);
    Rendered.Picture next = stage.picture(request(flat("m", square(0, 0.1f), RED)));
    assertSame(lent.rgb(), next.rgb());
    assertArrayEquals(kept.rgb(), next.rgb());
  }

  @Test
  void aPictureTooLargeIsRefusedWithTheLimit() throws Exception {
    RenderRequest small = request();
    RenderRequest huge =
        new RenderRequest(small.parts(), small.eye(), 100_000, 10, 1, small.background(), 9, small.selection());
    Rendered.Unavailable answer = assertInstanceOf(Rendered.Unavailable.class, stage.rendered(huge));
    assertTrue(answer.reason().contains("100000"), answer::reason);
  }
}
