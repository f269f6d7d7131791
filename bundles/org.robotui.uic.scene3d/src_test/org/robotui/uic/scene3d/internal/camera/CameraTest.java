package org.robotui.uic.scene3d.internal.camera;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.render.Eye;
import org.robotui.gl.shape.Box3;
import org.robotui.gl.shape.Ray;

class CameraTest {
  private static final double EXACT = 1e-9;
  private static final CameraPose LEVEL = new CameraPose(CameraKind.ORBIT, new Vector3(1, 2, 3), 5, 0, 0);

  @Test
  void theEyeIsBehindTheFocusAndAboveItWhereItLooksDown() {
    near(new Vector3(-4, 2, 3), LEVEL.eye());
    near(new Vector3(1, 2, 8), LEVEL.looking(0, Math.PI / 2).eye(), 0.01);
    near(new Vector3(1, -3, 3), LEVEL.looking(Math.PI / 2, 0).eye());
  }

  @Test
  void theMiddleOfThePictureIsTheLineOfSight() {
    Ray ray = new Lens(LEVEL, 800, 600).ray(400, 300);
    near(LEVEL.eye(), ray.origin());
    near(new Vector3(1, 0, 0), ray.direction());
  }

  @Test
  void anEdgeOfThePictureIsHalfTheFieldOfViewAway() {
    Ray top = new Lens(LEVEL, 800, 600).ray(400, 0);
    assertEquals(CameraPose.FIELD_OF_VIEW / 2, Math.asin(top.direction().z()), EXACT);
    Ray left = new Lens(LEVEL, 600, 600).ray(0, 300);
    assertEquals(CameraPose.FIELD_OF_VIEW / 2, Math.asin(left.direction().y()), EXACT);
  }

  @Test
  void aSpotAndItsRayAgree() {
    for (CameraKind kind : CameraKind.values()) {
      Lens lens = new Lens(CameraPose.START.as(kind), 700, 500);
      Ray ray = lens.ray(120, 333);
      Lens.Spot spot = lens.spot(ray.at(7)).orElseThrow();
      assertEquals(120, spot.x(), 1e-6);
      assertEquals(333, spot.y(), 1e-6);
    }
  }

  @Test
  void whatIsBehindIsNotSeen() {
    assertTrue(new Lens(LEVEL, 800, 600).spot(new Vector3(-10, 0, 0)).isEmpty());
  }

  @Test
  void panningMovesWhatIsAtTheFocusWithThePointer() {
    Lens before = new Lens(CameraPose.START, 800, 600);
    Lens after = new Lens(Moves.pan(before, 30, -20), 800, 600);
    Lens.Spot spot = after.spot(CameraPose.START.focus()).orElseThrow();
    assertEquals(430, spot.x(), 1e-6);
    assertEquals(280, spot.y(), 1e-6);
  }

  @Test
  void zoomingKeepsWhatIsUnderThePointer() {
    for (CameraKind kind : new CameraKind[]{CameraKind.ORBIT, CameraKind.TOP}) {
      Lens before = new Lens(CameraPose.START.as(kind), 800, 600);
      CameraPose nearer = Moves.zoom(before, 200, 450, 0.5);
      assertEquals(5, nearer.distance(), EXACT);
      Ray ray = before.ray(200, 450);
      double depth = before.pose().focus().minus(ray.origin()).dot(before.pose().forward())
          / ray.direction().dot(before.pose().forward());
      Lens.Spot spot = new Lens(nearer, 800, 600).spot(ray.at(depth)).orElseThrow();
      assertEquals(200, spot.x(), 1e-6);
      assertEquals(450, spot.y(), 1e-6);
    }
  }

  @Test
  void turningGoesRoundTheFocusOrKeepsTheEyeWhereItFlies() {
    CameraPose orbit = Moves.turn(CameraPose.START, 40, 10);
    near(CameraPose.START.focus(), orbit.focus());
    CameraPose flying = CameraPose.START.as(CameraKind.FLY);
    near(flying.eye(), Moves.turn(flying, 40, 10).eye());
  }

  @Test
  void nothingTurnsOverTheTop() {
    CameraPose steep = Moves.turn(CameraPose.START, 0, 100_000);
    assertTrue(steep.pitch() < Math.PI / 2);
    assertEquals(1, steep.up().norm(), EXACT);
  }

  @Test
  void fromAboveXIsRightAndYIsUp() {
    CameraPose top = CameraPose.START.as(CameraKind.TOP);
    near(new Vector3(0, 0, -1), top.forward());
    near(new Vector3(0, 1, 0), top.up());
    near(new Vector3(-1, 0, 0), top.left());
    Eye eye = top.toEye(Optional.of(new Box3(new Vector3(-1, -1, 0), new Vector3(1, 1, 30))));
    assertInstanceOf(Eye.Projection.Parallel.class, eye.projection());
    assertTrue(eye.fixedFromEye().translation().z() > 30);
  }

  @Test
  void aBoxThatIsFittedLiesWithinThePicture() {
    Box3 box = new Box3(new Vector3(-3, 1, 0), new Vector3(9, 4, 2));
    for (CameraKind kind : CameraKind.values()) {
      for (double aspect : new double[]{0.5, 1, 2}) {
        Lens lens = new Lens(CameraPose.START.as(kind).fit(box, aspect), 500 * aspect, 500);
        for (Vector3 corner : new Vector3[]{box.low(), box.high()}) {
          Lens.Spot spot = lens.spot(corner).orElseThrow();
          assertTrue(spot.x() >= 0 && spot.x() <= 500 * aspect && spot.y() >= 0 && spot.y() <= 500, kind + " " + spot);
        }
      }
    }
  }

  @Test
  void depthsHoldAllThatIsSeen() {
    Eye eye = LEVEL.toEye(Optional.of(new Box3(new Vector3(-100, -100, 0), new Vector3(100, 100, 5))));
    assertTrue(eye.far() > 140);
    assertTrue(eye.near() < 0.2 && eye.near() > 0);
  }

  @Test
  void theFloorUnderThePointerIsFound() {
    Lens lens = new Lens(CameraPose.START, 800, 600);
    near(Vector3.ZERO, lens.level(400, 300, 0).orElseThrow());
    assertTrue(new Lens(LEVEL, 800, 600).level(400, 0, 0).isEmpty());
  }

  @Test
  void aJourneyEndsWhereItShouldAndGoesTheShortWayRound() {
    CameraMotion rig = new CameraMotion(LEVEL.looking(3, 0));
    rig.go(LEVEL.looking(-3, 0.5), 0);
    assertTrue(rig.travels(CameraMotion.JOURNEY_NANOS / 2));
    double half = rig.at(CameraMotion.JOURNEY_NANOS / 2).yaw();
    assertTrue(Math.abs(half) > 3, "by way of 180 degrees, not of 0: " + half);
    assertFalse(rig.travels(CameraMotion.JOURNEY_NANOS));
    assertEquals(LEVEL.looking(-3, 0.5), rig.at(CameraMotion.JOURNEY_NANOS));
  }

  @Test
  void aFollowedFrameTakesTheCameraAlong() {
    CameraMotion rig = new CameraMotion(LEVEL);
    rig.follow(Optional.of(RigidTransform.planar(0, 0, 0)), false);
    near(LEVEL.focus(), rig.aim().focus());
    rig.follow(Optional.of(RigidTransform.planar(2, 1, 1)), false);
    near(new Vector3(3, 3, 3), rig.aim().focus());
    assertEquals(0, rig.aim().yaw(), EXACT);
  }

  @Test
  void aFollowedFrameAlsoTurnsIt() {
    CameraMotion rig = new CameraMotion(new CameraPose(CameraKind.ORBIT, new Vector3(1, 0, 0), 5, 0, 0));
    rig.follow(Optional.of(RigidTransform.planar(0, 0, 0)), true);
    rig.follow(Optional.of(RigidTransform.planar(0, 0, Math.PI / 2)), true);
    near(new Vector3(0, 1, 0), rig.aim().focus());
    assertEquals(Math.PI / 2, rig.aim().yaw(), EXACT);
  }

  private static void near(Vector3 expected, Vector3 actual) {
    near(expected, actual, EXACT);
  }

  private static void near(Vector3 expected, Vector3 actual, double tolerance) {
    assertEquals(0, expected.minus(actual).norm(), tolerance, expected + " " + actual);
  }
}
