package org.robotui.ui.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.api.config.Schema;
import org.robotui.testkit.FakeSettings;

/** A camera is where it was left, and gives that up where nothing is seen from there. */
class KeptViewportTest {
  private static final int SIZE = 400;
  private static final Bounds ROOM = new Bounds(0, 0, 10, 8);
  private static final Bounds ELSEWHERE = new Bounds(900, 900, 910, 908);
  private static final long SECOND = 1_000_000_000L;

  private final FakeSettings settings = new FakeSettings(Schema.of(KeptViewport.setting()));
  private long now;
  private int writes;

  private Camera camera() {
    return new Camera(200, 10, new KeptViewport(settings, () -> now, write -> {
      writes++;
      write.run();
    }));
  }

  private static Viewport seen(Camera camera, Bounds content) {
    camera.settle(SIZE, SIZE, Optional.of(content), Optional.empty());
    return camera.viewport();
  }

  @Test
  void withoutHandsNothingIsKept() {
    seen(camera(), ROOM);
    assertEquals(0, writes);
    assertTrue(seen(camera(), ROOM).visible().contains(10, 8), "all is shown");
  }

  @Test
  void whereHandsLeftItItIsAgain() {
    Camera before = camera();
    seen(before, ROOM);
    before.zoom(100, 100, 3);
    before.pan(20, -10);
    assertEquals(seen(before, ROOM), seen(camera(), ROOM));
  }

  @Test
  void showingAllForgetsIt() {
    Camera before = camera();
    Viewport all = seen(before, ROOM);
    before.center(2, 2);
    before.fit(Optional.of(ROOM));
    assertEquals(all, seen(camera(), ROOM));
  }

  @Test
  void oneThingThatIsShownWholeStaysSo() {
    Camera camera = camera();
    seen(camera, ROOM);
    camera.fitTo(new Bounds(1, 1, 2, 2));
    assertFalse(seen(camera, ROOM).visible().contains(10, 8), "the rest of the room");
    assertEquals(camera.viewport(), seen(camera(), ROOM));
  }

  @Test
  void whatIsNowhereNearIsWaitedForAndThenAllIsShown() {
    Camera before = camera();
    before.center(2, 2);
    Viewport left = seen(before, ROOM);
    Camera next = camera();
    assertEquals(left, seen(next, ELSEWHERE));
    now += 4 * SECOND;
    assertEquals(left, seen(next, ELSEWHERE));
    now += 2 * SECOND;
    assertTrue(seen(next, ELSEWHERE).visible().contains(905, 904));
    assertTrue(seen(camera(), ROOM).visible().contains(10, 8), "and forgotten");
  }

  @Test
  void whatComesLaterIsSeenFromWhereItWasLeft() {
    Camera before = camera();
    before.center(2, 2);
    Viewport left = seen(before, ROOM);
    Camera next = camera();
    seen(next, ELSEWHERE);
    now += 4 * SECOND;
    seen(next, ELSEWHERE.union(ROOM));
    now += 4 * SECOND;
    assertEquals(left, seen(next, ELSEWHERE));
  }
}
