package org.robotui.entity.gps;

import java.util.Locale;
import org.robotui.ui.Figures;

/** Places as users read and copy them. Pure, for all threads. */
public final class GeoText {
  private static final int DECIMALS = 6;
  private static final long HUNDREDTHS = 100;
  private static final long SIXTY = 60;

  private GeoText() {}

  /**
   * In degrees with decimals.
   *
   * @param place the place
   * @return for example {@code 42.375812° N  71.147395° W}
   */
  public static String decimal(GeoPoint place) {
    return Figures.fixed(Math.toDegrees(Math.abs(place.latitude())), DECIMALS) + "\u00b0\u00a0" + northOrSouth(place)
        + "  "
        + Figures.fixed(Math.toDegrees(Math.abs(place.longitude())), DECIMALS) + "\u00b0\u00a0" + eastOrWest(place);
  }

  /**
   * In degrees, minutes and seconds.
   *
   * @param place the place
   * @return for example {@code 42°22′32.92″ N  71°08′50.62″ W}
   */
  public static String sexagesimal(GeoPoint place) {
    return sexagesimal(place.latitude(), 2) + "\u00a0" + northOrSouth(place) + "  "
        + sexagesimal(place.longitude(), 3) + "\u00a0" + eastOrWest(place);
  }

  /**
   * For the clipboard and other programs: signed degrees with a decimal point, a comma between.
   *
   * @param place the place
   * @return for example {@code 42.3758120, -71.1473947}, exact to about a centimetre
   */
  public static String plain(GeoPoint place) {
    return String.format(Locale.ROOT, "%.7f, %.7f", Math.toDegrees(place.latitude()),
        Math.toDegrees(place.longitude()));
  }

  /**
   * A distance on the earth.
   *
   * @param metres the distance
   * @return for example {@code 12.34 m} or {@code 3.412 km}
   */
  public static String distance(double metres) {
    return metres < 1000 ? Figures.of(metres, 2, "m") : Figures.of(metres / 1000, metres < 100_000 ? 3 : 1, "km");
  }

  /**
   * A bearing.
   *
   * @param radians from north over east
   * @return three digits and a decimal, for example {@code 045.0°}
   */
  public static String bearing(double radians) {
    double degrees = Math.round(Math.toDegrees(radians) * 10) / 10.0 % 360;
    return String.format(Locale.ROOT, "%05.1f\u00b0", degrees);
  }

  /** Counted in hundredths of a second, so that nothing is ever rounded up to sixty. */
  private static String sexagesimal(double radians, int digits) {
    long all = Math.round(Math.toDegrees(Math.abs(radians)) * SIXTY * SIXTY * HUNDREDTHS);
    long degrees = all / (SIXTY * SIXTY * HUNDREDTHS);
    long minutes = all / (SIXTY * HUNDREDTHS) % SIXTY;
    long seconds = all / HUNDREDTHS % SIXTY;
    return String.format(Locale.ROOT, "%0" + digits + "d\u00b0%02d\u2032%02d.%02d\u2033", degrees, minutes, seconds,
        all % HUNDREDTHS);
  }

  private static String northOrSouth(GeoPoint place) {
    return place.latitude() < 0 ? "S" : "N";
  }

  private static String eastOrWest(GeoPoint place) {
    return place.longitude() < 0 ? "W" : "E";
  }
}
