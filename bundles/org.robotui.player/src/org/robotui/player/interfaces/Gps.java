package org.robotui.player.interfaces;

import org.robotui.player.layout.Kind;

/** Receivers of satellite positions. The interface {@code gps}. */
public final class Gps {

  /** Data: state. */
  public static final Kind.Data<State> STATE = new Kind.Data<>("gps", "state", State.class);

  private Gps() {}

  /**
   * Where the receiver is; units as the device sends them.
   *
   * @param seconds UTC since 1970
   * @param micros and the rest of it, microseconds
   * @param latitude north, 1e-7 degrees
   * @param longitude east, 1e-7 degrees
   * @param altitude above the sea, millimetres
   * @param speed over ground, metres per second
   * @param course over ground, degrees
   * @param utmEast UTM, metres
   * @param utmNorth UTM, metres
   * @param quality 0 none, 1 GPS, 2 DGPS
   * @param satellites in use
   * @param hdop horizontal dilution, tenths
   * @param vdop vertical dilution, tenths
   * @param horizontalError estimated, metres
   * @param verticalError estimated, metres
   */
  public record State(
      long seconds, long micros, int latitude, int longitude, int altitude, double speed, double course, double utmEast,
      double utmNorth,
      long quality, long satellites, long hdop, long vdop, double horizontalError, double verticalError) {}
}
