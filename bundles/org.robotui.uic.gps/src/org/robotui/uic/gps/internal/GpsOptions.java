package org.robotui.uic.gps.internal;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.TextRule;
import org.robotui.api.config.ValueType;
import org.robotui.entity.gps.GeoPoint;

/**
 * The settings of the GPS view.
 *
 * @param follow whether a receiver stays in the middle
 * @param followed which one, as component.port; empty for the first
 * @param origin where the plane touches the earth; none for the first fix
 * @param trailNanos how long ways are kept
 * @param ways how ways are coloured
 * @param sexagesimal whether coordinates are shown in degrees, minutes and seconds
 * @param grid whether the grid is drawn
 */
public record GpsOptions(
    boolean follow, String followed, Optional<GeoPoint> origin, long trailNanos, Ways ways, boolean sexagesimal,
    boolean grid) {
  public static final String FOLLOW = "follow";
  public static final String FOLLOWED = "followed";
  public static final String ORIGIN = "origin";
  public static final String FIRST_FIX = "first_fix";
  public static final String FIXED = "fixed";
  public static final String ORIGIN_LATITUDE = "origin_latitude";
  public static final String ORIGIN_LONGITUDE = "origin_longitude";
  public static final String TRAIL_MINUTES = "trail_minutes";
  public static final String WAY_COLORS = "way_colors";
  public static final String COORDINATES = "coordinates";
  public static final String DECIMAL = "decimal";
  public static final String DMS = "dms";
  public static final String SHOW_GRID = "show_grid";

  private static final double NANOS_PER_MINUTE = 60e9;
  private static final double LONGEST_MINUTES = 100_000;

  /** How ways are coloured. */
  public enum Ways {
    /** By quality where there is one receiver, else by receiver. */
    AUTO("Automatic"),
    /** A colour a receiver. */
    RECEIVER("By receiver"),
    /** By the quality of the fixes. */
    QUALITY("By quality");

    private final String label;

    Ways(String label) {
      this.label = label;
    }

    /** As users read it. */
    public String label() {
      return label;
    }

    /** As written in settings. */
    public String id() {
      return name().toLowerCase(Locale.ROOT);
    }
  }

  /** What the view can be configured with. */
  public static Schema schema() {
    return Schema.of(
        Setting.of(FOLLOW, new ValueType.Flag(), false, "Keep a receiver in the middle."),
        Setting.of(FOLLOWED, new ValueType.Text(TextRule.SOURCE.orEmpty("\"\"")), "",
            "Which receiver is followed, as component.port; empty for the first."),
        Setting.of(ORIGIN, new ValueType.Choice(List.of(FIRST_FIX, FIXED)), FIRST_FIX,
            "Where metres are counted from: the first fix, or origin_latitude and origin_longitude."),
        Setting.of(ORIGIN_LATITUDE, new ValueType.Num(-90, 90, "\u00b0"), 0.0, "Degrees, north is positive."),
        Setting.of(ORIGIN_LONGITUDE, new ValueType.Num(-180, 180, "\u00b0"), 0.0, "Degrees, east is positive."),
        Setting.of(TRAIL_MINUTES, new ValueType.Num(0, LONGEST_MINUTES, "min"), 240.0, "How long tracks are kept."),
        Setting.of(WAY_COLORS, new ValueType.Choice(List.of(Ways.AUTO.id(), Ways.RECEIVER.id(), Ways.QUALITY.id())),
            Ways.AUTO.id(),
            "Colour of tracks: by quality of the fixes, by receiver, or auto: by quality where there is one receiver."),
        Setting.of(COORDINATES, new ValueType.Choice(List.of(DECIMAL, DMS)), DECIMAL,
            "Show coordinates in degrees, or in degrees, minutes and seconds."),
        Setting.of(SHOW_GRID, new ValueType.Flag(), true, "Show the grid."));
  }

  /** Reads checked settings. */
  public static GpsOptions of(Settings s) {
    Optional<GeoPoint> origin = s.text(ORIGIN).equals(FIXED)
        ? Optional.of(GeoPoint.degrees(s.number(ORIGIN_LATITUDE), s.number(ORIGIN_LONGITUDE)))
        : Optional.empty();
    return new GpsOptions(s.flag(FOLLOW), s.text(FOLLOWED), origin, (long) (s.number(TRAIL_MINUTES) * NANOS_PER_MINUTE),
        Ways.valueOf(s.text(WAY_COLORS).toUpperCase(Locale.ROOT)), s.text(COORDINATES).equals(DMS), s.flag(SHOW_GRID));
  }
}
