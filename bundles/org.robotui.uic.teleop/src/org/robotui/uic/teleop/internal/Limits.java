package org.robotui.uic.teleop.internal;

import org.robotui.api.config.Settings;

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

  Speed at(Stick stick) {
    return new Speed(stick.forward() * linear, stick.left() * angular);
  }
}
