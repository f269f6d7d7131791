package org.robotui.uic.teleop.internal;

import org.robotui.api.config.Settings;
import org.robotui.data.command.MotionLimits;

/**
 * How fast and how suddenly the user wants to drive.
 *
 * @param linear metres per second at full stick
 * @param angular radians per second at full stick
 * @param linearAcceleration metres per second squared
 * @param angularAcceleration radians per second squared
 */
record Limits(double linear, double angular, double linearAcceleration, double angularAcceleration) {
  static Limits of(Settings settings) {
    return new Limits(settings.number(TeleopType.MAX_LINEAR), settings.number(TeleopType.MAX_ANGULAR),
        settings.number(TeleopType.ACCELERATION_LINEAR), settings.number(TeleopType.ACCELERATION_ANGULAR));
  }

  /** What is left of them where the robot may not be commanded as fast. */
  Limits within(MotionLimits robot) {
    return new Limits(Math.min(linear, robot.linear()), Math.min(angular, robot.angular()), linearAcceleration,
        angularAcceleration);
  }

  Speed at(Stick stick) {
    return new Speed(stick.forward() * linear, stick.left() * angular);
  }
}
