package org.robotui.roblets.roblet;

import java.util.Locale;

/** Where a roblet is in its life. */
public enum RobletState {
  /** It begins, or begins again. */
  STARTING,
  /** It does what it does. */
  RUNNING,
  /** It has not returned from one call for seconds. */
  HANGING,
  /** It threw something; another instance will be started. */
  FAILED,
  /** It was ended. */
  STOPPED;

  /**
   * As beacons say it.
   *
   * @return in small letters
   */
  public String word() {
    return name().toLowerCase(Locale.ROOT);
  }
}
