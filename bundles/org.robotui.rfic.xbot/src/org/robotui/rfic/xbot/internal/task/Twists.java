package org.robotui.rfic.xbot.internal.task;

import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;

/** Differences of poses: three metres, then three radians, in the axes that both poses are given in. */
final class Twists {
  static final int SIZE = 6;
  private static final double GIMBAL = 1e-7;

  private Twists() {}

  /** The translation and the rotation vector from one pose to another. */
  static double[] difference(RigidTransform from, RigidTransform to) {
    Vector3 way = to.translation().minus(from.translation());
    Quaternion turn = to.rotation().times(from.rotation().inverse());
    double sign = turn.w() < 0 ? -1 : 1;
    Vector3 axis = new Vector3(sign * turn.x(), sign * turn.y(), sign * turn.z());
    double sine = axis.norm();
    double angle = 2 * Math.atan2(sine, sign * turn.w());
    Vector3 about = axis.times(sine > 0 ? angle / sine : 0);
    return new double[]{way.x(), way.y(), way.z(), about.x(), about.y(), about.z()};
  }

  static double metres(double[] twist) {
    return new Vector3(twist[0], twist[1], twist[2]).norm();
  }

  static double radians(double[] twist) {
    return new Vector3(twist[3], twist[4], twist[5]).norm();
  }

  /** Roll, pitch and yaw about fixed axes; where the pitch is a right angle, all of the rest is yaw. */
  static double[] rollPitchYaw(Quaternion q) {
    Vector3 x = q.rotate(new Vector3(1, 0, 0));
    double level = Math.hypot(x.x(), x.y());
    double pitch = Math.atan2(-x.z(), level);
    if (level > GIMBAL) {
      return new double[]{q.roll(), pitch, q.yaw()};
    }
    Vector3 y = q.rotate(new Vector3(0, 1, 0));
    return new double[]{0, pitch, Math.atan2(-y.x(), y.y())};
  }
}
