package org.robotui.uic.scene3d.internal.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.gl.render.Gl;
import org.robotui.gl.render.Rendered;
import org.robotui.gl.shape.Rgba;
import org.robotui.uic.scene3d.internal.camera.CameraMotion;
import org.robotui.uic.scene3d.internal.camera.CameraPose;
import org.robotui.uic.scene3d.internal.camera.Moves;
import org.robotui.uic.scene3d.internal.model.Stage;

class FrameSchedulerTest {
  private static final PictureRequest LOOK = new PictureRequest(40, 30, 1, Rgba.of(0x1b1e23));
  private final FakeGl gl = new FakeGl();
  private final CameraMotion rig = new CameraMotion(CameraPose.START);
  private Optional<Gl> graphics = Optional.of(gl);
  private long now = 10_000_000_000L;
  private int arrived;
  private final List<Rendered.Picture> pictures = new ArrayList<>();
  private final FrameScheduler studio =
      new FrameScheduler(() -> graphics, rig, () -> now, (picture, from) -> pictures.add(picture), () -> arrived++);

  private static Stage stage(long version) {
    return new Stage(version, Map.of(), List.of(), Optional.empty(), List.of(), List.of(), 0);
  }

  @Test
  void nothingIsOpenedBeforeSomebodyLooks() {
    studio.show(stage(1), List.of());
    studio.pump();
    assertEquals(0, gl.open);
    studio.look(LOOK);
    assertEquals(1, gl.open);
    assertEquals(1, gl.requests.size());
  }

  @Test
  void untilAPictureCameOfWhatIsToBeShownTheSceneIsBeingPrepared() {
    studio.look(LOOK);
    gl.answer(0.01, 0, 0);
    assertTrue(studio.prepares(), "that was a picture of nothing");
    studio.show(stage(0), List.of());
    assertTrue(studio.prepares());
    gl.answer(0.01, 5, 0);
    assertFalse(studio.prepares());
    studio.show(stage(1), List.of());
    assertFalse(studio.prepares(), "there is a picture");
  }

  @Test
  void whoWaitsLongForAPictureIsToldSo() {
    studio.look(LOOK);
    now += FrameScheduler.LONG_NANOS;
    assertFalse(studio.waits());
    now++;
    assertTrue(studio.waits());
    gl.answer(0.6, 5, 0);
    assertFalse(studio.waits());
  }

  @Test
  void onePictureAtATimeAndTheNewestStateNext() {
    studio.look(LOOK);
    studio.show(stage(1), List.of());
    studio.show(stage(2), List.of());
    assertEquals(1, gl.requests.size());
    gl.answer(0.01, 5, 0);
    assertEquals(2, gl.requests.size());
    gl.answer(0.01, 5, 0);
    assertEquals(2, gl.requests.size());
    assertEquals(2, arrived);
    studio.show(stage(2), List.of());
    assertEquals(2, gl.requests.size());
  }

  @Test
  void whileTheCameraMovesPointsAreThinnedAndAtRestAllAreShown() {
    studio.look(LOOK);
    gl.answer(0.4, 1_000_000, 0);
    rig.move(p -> Moves.turn(p, 5, 0));
    studio.moved();
    assertEquals(50_000, gl.requests.getLast().pointBudget(), 1);
    gl.answer(0.01, 50_000, 950_000);
    rig.move(p -> Moves.turn(p, 5, 0));
    studio.moved();
    assertEquals(100_000, gl.requests.getLast().pointBudget(), 1);
    gl.answer(0.02, 100_000, 900_000);
    int before = gl.requests.size();
    studio.pump();
    assertEquals(before, gl.requests.size());
    now += FrameScheduler.REST_NANOS;
    studio.pump();
    assertEquals(Integer.MAX_VALUE, gl.requests.getLast().pointBudget());
    assertEquals(before + 1, gl.requests.size());
  }

  @Test
  void aCompletePictureDoesNotRaiseWhatIsDrawnWhileTheCameraMoves() {
    studio.look(LOOK);
    gl.answer(0.4, 5_000_000, 0);
    rig.move(p -> Moves.turn(p, 5, 0));
    studio.moved();
    gl.answer(0.04, 250_000, 4_750_000);
    now += FrameScheduler.REST_NANOS;
    studio.pump();
    gl.answer(0.4, 5_000_000, 0);
    rig.move(p -> Moves.turn(p, 5, 0));
    studio.moved();
    assertEquals(125_000, gl.requests.getLast().pointBudget(), 1,
        "as those learned that are drawn one here, one there");
  }

  @Test
  void aFastMachineIsNeverThinned() {
    studio.look(LOOK);
    gl.answer(0.005, 1_000_000, 0);
    rig.move(p -> Moves.turn(p, 5, 0));
    studio.moved();
    assertTrue(gl.requests.getLast().pointBudget() > 1_000_000);
    gl.answer(0.005, 1_000_000, 0);
    now += FrameScheduler.REST_NANOS;
    int before = gl.requests.size();
    studio.pump();
    assertEquals(before, gl.requests.size(), "it is complete");
  }

  @Test
  void aPictureOfAllPointsIsGivenUpWhenTheCameraIsMovedAndDrawnWhenItStands() {
    studio.look(LOOK);
    gl.answer(0.4, 5_000_000, 0);
    studio.show(stage(1), List.of());
    assertEquals(Integer.MAX_VALUE, gl.requests.getLast().pointBudget());
    rig.move(p -> Moves.turn(p, 5, 0));
    studio.moved();
    assertEquals(1, gl.givenUp);
    assertEquals(250_000, gl.requests.getLast().pointBudget(), 1);
    rig.move(p -> Moves.turn(p, 5, 0));
    studio.moved();
    assertEquals(1, gl.givenUp, "one of few points is not");
    gl.answer(0.02, 250_000, 4_750_000);
    gl.answer(0.02, 250_000, 4_750_000);
    now += FrameScheduler.REST_NANOS;
    studio.pump();
    assertEquals(Integer.MAX_VALUE, gl.requests.getLast().pointBudget());
    int before = gl.requests.size();
    gl.answer(0.4, 5_000_000, 0);
    studio.pump();
    assertEquals(before, gl.requests.size());
  }

  @Test
  void whileNothingWasTriedACloudIsThinnedAsWell() {
    studio.look(LOOK);
    rig.move(p -> Moves.turn(p, 5, 0));
    studio.moved();
    assertEquals(Budget.UNTRIED, gl.requests.getLast().pointBudget());
  }

  @Test
  void whereThinningIsNotWantedASlowMachineShowsAllPointsWhileTheCameraMoves() {
    studio.thin(false);
    studio.look(LOOK);
    gl.answer(0.4, 1_000_000, 0);
    rig.move(p -> Moves.turn(p, 5, 0));
    studio.moved();
    assertEquals(Integer.MAX_VALUE, gl.requests.getLast().pointBudget());
  }

  @Test
  void withoutOpenGlItSaysWhyAndTriesAgainLater() {
    Rendered.Unavailable none = new Rendered.Unavailable("no libGL", "install libgl1");
    studio.look(LOOK);
    gl.answers.getLast().complete(none);
    assertEquals(Optional.of(none), studio.unavailable());
    studio.pump();
    assertEquals(1, gl.requests.size());
    now += 6_000_000_000L;
    studio.pump();
    assertEquals(2, gl.requests.size());
    gl.answer(0.01, 1, 0);
    assertTrue(studio.unavailable().isEmpty());
  }

  @Test
  void aBundleThatIsNotThereIsSaidAndOneThatComesIsUsed() {
    graphics = Optional.empty();
    studio.look(LOOK);
    assertTrue(studio.unavailable().orElseThrow().reason().contains("org.robotui.gl"));
    graphics = Optional.of(gl);
    now += 6_000_000_000L;
    studio.pump();
    assertEquals(1, gl.open);
    graphics = Optional.of(new FakeGl());
    gl.answer(0.01, 1, 0);
    studio.show(stage(7), List.of());
    assertEquals(0, gl.open);
  }

  @Test
  void aSnapshotHasItsOwnSizeAndIsComplete() {
    studio.look(LOOK);
    gl.answer(0.01, 1, 0);
    List<Rendered> made = new ArrayList<>();
    studio.snapshot(1920, 1080).thenAccept(r -> made.add(r));
    assertEquals(1920, gl.requests.getLast().width());
    assertEquals(36, gl.requests.getLast().scale(), 0.01);
    gl.answer(0.5, 1, 0);
    assertEquals(1080, ((Rendered.Picture) made.getFirst()).height());
  }

  @Test
  void atRestAndAtTheEndTheRendererIsGivenBack() {
    gl.atOnce = true;
    studio.look(LOOK);
    studio.rest();
    assertEquals(0, gl.open);
    studio.look(LOOK);
    assertEquals(1, gl.open);
    studio.close();
    assertEquals(0, gl.open);
  }

  @Test
  void aPictureIsShownAndItsPixelsAreHandedBack() {
    studio.look(LOOK);
    gl.answer(0.01, 5, 0);
    assertEquals(1, pictures.size());
    assertEquals(1, gl.recycled);
    studio.snapshot(1920, 1080);
    gl.answer(0.01, 5, 0);
    assertEquals(1, pictures.size());
    assertEquals(1, gl.recycled);
  }

  @Test
  void theNextPictureIsDrawnWhileOneIsBroughtToTheScreen() {
    List<Integer> asked = new ArrayList<>();
    try (FrameScheduler other = new FrameScheduler(() -> graphics, rig, () -> now,
        (picture, from) -> asked.add(gl.requests.size()), () -> arrived++)) {
      other.look(LOOK);
      other.show(stage(1), List.of());
      gl.answer(0.01, 5, 0);
      assertEquals(List.of(2), asked, "the second was asked for before the first was shown");
    }
  }

  @Test
  void aRendererThatAnswersAtOnceIsNotAskedWithinItsAnswer() {
    gl.atOnce = true;
    List<Long> depths = new ArrayList<>();
    Screen screen = (picture, from) -> depths.add(StackWalker.getInstance().walk(frames -> frames.count()));
    try (
        FrameScheduler other = new FrameScheduler(() -> graphics, rig, () -> now += 100_000, screen, () -> arrived++)) {
      other.look(LOOK);
      rig.go(Moves.turn(CameraPose.START, 300, 0), now);
      other.pump();
      assertTrue(depths.size() > 100, "a picture for each look at the clock on the way");
      assertEquals(depths.get(50), depths.getLast());
    }
  }

  @Test
  void anotherScreenIsGivenAPictureThoughNothingChanged() {
    gl.atOnce = true;
    studio.look(LOOK);
    studio.look(LOOK);
    assertEquals(1, pictures.size());
    studio.again();
    assertEquals(2, pictures.size());
  }

  @Test
  void picturesAreCounted() {
    gl.atOnce = true;
    studio.look(LOOK);
    for (int i = 2; i < 27; i++) {
      now += 40_000_000L;
      studio.show(stage(i), List.of());
    }
    assertEquals(25, studio.rate(), 0.01);
  }
}
