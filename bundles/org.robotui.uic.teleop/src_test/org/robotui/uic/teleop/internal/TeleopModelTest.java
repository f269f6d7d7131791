package org.robotui.uic.teleop.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class TeleopModelTest {
  private static final long MS = 1_000_000;
  private static final double EPS = 1e-9;
  private static final Limits LIMITS = new Limits(0.4, 1, 1, 3);

  private final TeleopModel model = new TeleopModel();

  @Test
  void restsUntilAHandComes() {
    assertFalse(model.held(0));
    assertEquals(Stick.REST, model.stick(0));
    assertEquals(Speed.ZERO, model.step(0, LIMITS));
  }

  @Test
  void aKeyHoldsAndItsReleaseEndsAfterTheGrace() {
    model.press(DriveKey.FORWARD, 0);
    assertTrue(model.held(5_000 * MS), "holding needs no repeats");
    model.release(DriveKey.FORWARD, 5_000 * MS);
    assertTrue(model.held(5_010 * MS));
    assertFalse(model.held(5_000 * MS + TeleopModel.GRACE_NANOS));
  }

  @Test
  void autoRepeatAsReleaseAndPressPairsNeverLetsGo() {
    model.press(DriveKey.LEFT, 0);
    for (long t = 500; t < 2_000; t += 33) {
      model.release(DriveKey.LEFT, t * MS);
      assertTrue(model.held(t * MS));
      model.press(DriveKey.LEFT, t * MS + 1);
      assertTrue(model.held((t + 32) * MS), "at " + t);
    }
  }

  @Test
  void keysAddUpAndOppositeOnesCancel() {
    model.press(DriveKey.FORWARD, 0);
    model.press(DriveKey.LEFT, 0);
    assertEquals(new Stick(1, 1), model.stick(0));
    model.press(DriveKey.BACK, 0);
    assertEquals(new Stick(0, 1), model.stick(0));
    assertTrue(model.held(0), "cancelled keys still hold");
  }

  @Test
  void theSameDirectionTwiceIsNotFaster() {
    model.press(DriveKey.FORWARD, 0);
    model.press(DriveKey.FORWARD_LEFT, 0);
    assertEquals(new Stick(1, 1), model.stick(0));
  }

  @Test
  void shiftHalves() {
    model.press(DriveKey.FORWARD, 0);
    model.half(true);
    assertEquals(new Stick(0.5, 0), model.stick(0));
    model.half(false);
    assertEquals(new Stick(1, 0), model.stick(0));
  }

  @Test
  void theMouseWinsOverKeysAndSpringsBack() {
    model.press(DriveKey.FORWARD, 0);
    model.drag(new Stick(-0.5, 0.25));
    assertEquals(new Stick(-0.5, 0.25), model.stick(0));
    model.dragEnd();
    assertEquals(new Stick(1, 0), model.stick(0));
  }

  @Test
  void aHandInTheMiddleOfTheStickStillHolds() {
    model.drag(Stick.REST);
    assertTrue(model.held(0));
    assertEquals(Speed.ZERO, model.step(0, LIMITS));
  }

  @Test
  void speedRampsUpToTheLimitAndNoFurther() {
    model.press(DriveKey.FORWARD, 0);
    double last = 0;
    for (int i = 0; i < 20; i++) {
      double speed = model.step(i * 50 * MS, LIMITS).forward();
      assertTrue(speed - last <= 0.05 + EPS, "a step of " + (speed - last));
      assertTrue(speed >= last);
      last = speed;
    }
    assertEquals(0.4, last, EPS);
  }

  @Test
  void reversingRampsThroughZero() {
    model.drag(new Stick(1, 0));
    for (int i = 0; i < 20; i++) {
      model.step(i * 50 * MS, LIMITS);
    }
    model.drag(new Stick(-1, 0));
    assertEquals(0.35, model.step(1_000 * MS, LIMITS).forward(), EPS);
  }

  @Test
  void lettingGoIsZeroAtOnceAndTheNextStartRampsFromZero() {
    model.drag(new Stick(1, 0));
    for (int i = 0; i < 20; i++) {
      model.step(i * 50 * MS, LIMITS);
    }
    model.dragEnd();
    assertEquals(Speed.ZERO, model.step(1_000 * MS, LIMITS));
    model.drag(new Stick(1, 0));
    assertEquals(0.05, model.step(60_000 * MS, LIMITS).forward(), EPS);
  }

  @Test
  void aPauseBetweenTicksDoesNotJump() {
    model.drag(new Stick(1, 0));
    model.step(0, new Limits(10, 1, 1, 1));
    assertEquals(0.05 + 0.1, model.step(5_000 * MS, new Limits(10, 1, 1, 1)).forward(), EPS);
  }

  @Test
  void aLowerLimitIsApproachedByTheRampToo() {
    model.drag(new Stick(1, 0));
    for (int i = 0; i < 20; i++) {
      model.step(i * 50 * MS, LIMITS);
    }
    assertEquals(0.35, model.step(1_000 * MS, new Limits(0.1, 1, 1, 3)).forward(), EPS);
  }

  @Test
  void afterLettingGoAKeyMustComeUpFirst() {
    model.press(DriveKey.FORWARD, 0);
    model.letGo();
    assertFalse(model.held(0));
    model.press(DriveKey.FORWARD, 10 * MS);
    assertFalse(model.held(10 * MS), "a repeat is no new press");
    model.release(DriveKey.FORWARD, 40 * MS);
    model.press(DriveKey.FORWARD, 40 * MS + 1);
    assertFalse(model.held(40 * MS + 1), "nor is a repeat that comes as a pair");
    model.release(DriveKey.FORWARD, 100 * MS);
    model.press(DriveKey.FORWARD, 200 * MS);
    assertTrue(model.held(200 * MS));
  }

  @Test
  void anotherKeyDrivesWhileOneIsSpent() {
    model.press(DriveKey.FORWARD, 0);
    model.letGo();
    model.press(DriveKey.LEFT, 10 * MS);
    assertTrue(model.held(10 * MS));
    assertEquals(new Stick(0, 1), model.stick(10 * MS));
  }

  @Test
  void lostFocusForgetsAllKeysSoThatNoneSticks() {
    model.press(DriveKey.FORWARD, 0);
    model.half(true);
    model.drag(new Stick(1, 1));
    model.forget();
    assertFalse(model.held(0));
    model.press(DriveKey.FORWARD, MS);
    assertEquals(new Stick(1, 0), model.stick(MS), "without shift, which was forgotten too");
  }

  @Test
  void aReleaseWithoutAPressIsNothing() {
    model.release(DriveKey.BACK, 0);
    assertFalse(model.held(0));
  }

  @Test
  void worksWhenNanoTimeWrapsAround() {
    long start = Long.MAX_VALUE - 10 * MS;
    model.press(DriveKey.FORWARD, start);
    model.step(start, LIMITS);
    assertEquals(0.1, model.step(start + 50 * MS, LIMITS).forward(), EPS);
    model.release(DriveKey.FORWARD, start + 60 * MS);
    assertTrue(model.held(start + 70 * MS));
    assertFalse(model.held(start + 100 * MS));
  }
}
