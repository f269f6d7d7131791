package org.robotui.entity.marker.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.robotui.data.marker.InteractiveMarker.Mode;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.shape.Ray;

class HandleDragTest {
  private static final Vector3 X = new Vector3(1, 0, 0);
  private static final Vector3 UP = new Vector3(0, 0, 1);
  private static final RigidTransform BODY = RigidTransform.planar(2, 0, 0);

  /** Straight down onto a place of the floor. */
  private static Ray down(double x, double y) {
    return new Ray(new Vector3(x, y, 10), new Vector3(0, 0, -1));
  }

  private static RigidTransform drag(Mode mode, Vector3 axis, Vector3 place, double x, double y) {
    HandleDrag grip = new HandleDrag(mode, axis, BODY, place, down(place.x(), place.y()));
    return grip.drag(down(x, y));
  }

  private static void assertAt(double x, double y, double yaw, RigidTransform body) {
    assertEquals(x, body.translation().x(), 1e-9, body.toString());
    assertEquals(y, body.translation().y(), 1e-9, body.toString());
    assertEquals(0, body.translation().z(), 1e-9, body.toString());
    assertEquals(yaw, body.rotation().yaw(), 1e-9, body.toString());
  }

  @Test
  void alongAnAxisItMovesAsFarAsTheHandAndNoWhereElse() {
    assertAt(5, 0, 0, drag(Mode.MOVE_AXIS, X, new Vector3(2.5, 0, 0), 5.5, 7));
    assertAt(2, 0, 0, drag(Mode.MOVE_AXIS, new Vector3(0, 0, 1), new Vector3(2, 0, 0), 5, 7));
  }

  @Test
  void inAPlaneItFollowsTheHand() {
    assertAt(3, 4, 0, drag(Mode.MOVE_PLANE, UP, new Vector3(2.5, 0.5, 0), 3.5, 4.5));
    assertAt(3, 4, 0, drag(Mode.MOVE_3D, X, new Vector3(2.5, 0.5, 0), 3.5, 4.5));
  }

  @Test
  void aboutAnAxisItTurnsByTheAngleOfTheHand() {
    assertAt(2, 0, Math.PI / 2, drag(Mode.ROTATE_AXIS, UP, new Vector3(3, 0, 0), 2, 5));
    assertAt(2, 0, -Math.PI / 4, drag(Mode.ROTATE_AXIS, UP, new Vector3(3, 0, 0), 4, -2));
  }

  @Test
  void pulledAtItsRimItTurnsAfterTheHand() {
    HandleDrag grip = new HandleDrag(Mode.MOVE_ROTATE, UP, BODY, new Vector3(3, 0, 0), down(3, 0));
    RigidTransform body = BODY;
    for (int i = 1; i <= 400; i++) {
      body = grip.drag(down(3, i * 0.05));
    }
    assertEquals(Math.PI / 2, body.rotation().yaw(), 0.01, "its front follows the way");
    assertEquals(19, body.translation().y(), 0.01, "an arm's length behind the hand");
  }

  @Test
  void atItsMiddleItIsMovedWithoutTurning() {
    assertAt(3, 4, 0, drag(Mode.MOVE_ROTATE, UP, new Vector3(2, 0, 0), 3, 4));
  }

  @Test
  void aBallRollsUnderTheFinger() {
    RigidTransform turned = drag(Mode.ROTATE_3D, X, new Vector3(2, 0, 1), 3, 0);
    assertEquals(Math.PI / 2, turned.rotation().pitch(), 1e-6);
    assertEquals(BODY.translation(), turned.translation());
  }

  @Test
  void raysThatMeetNothingLeaveItWhereItIs() {
    HandleDrag flat = new HandleDrag(Mode.MOVE_PLANE, UP, BODY, Vector3.ZERO, down(0, 0));
    assertEquals(BODY, flat.drag(new Ray(new Vector3(0, 0, 1), X)), "along the plane");
    assertEquals(BODY, flat.drag(new Ray(new Vector3(0, 0, 1), UP)), "behind the eye");
    HandleDrag axis = new HandleDrag(Mode.MOVE_AXIS, X, BODY, Vector3.ZERO, down(0, 0));
    assertEquals(BODY, axis.drag(new Ray(new Vector3(0, 0, 1), X)));
    assertTrue(new HandleDrag(Mode.BUTTON, X, BODY, Vector3.ZERO, down(0, 0)).drag(down(5, 5)).equals(BODY));
  }
}
