package org.robotui.uic.gps.internal;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.TextRule;
import org.robotui.api.config.ValueType;
import org.robotui.entity.gps.GeoPoint;
import org.robotui.ui.display.DisplayEntry;
import org.robotui.ui.display.DisplayKind;
import org.robotui.ui.display.DisplaySpec;
import org.robotui.ui.layer.LayerStack;
import org.robotui.ui.scene.KeptViewport;

/**
 * The settings of the GPS view.
 *
 * @param follow whether a receiver stays in the middle
 * @param followed which one, as component.port; empty for the first
 * @param origin where the plane touches the earth; none for the first fix
 * @param beginnings settings with which receivers begin that nobody has listed
 * @param sexagesimal whether coordinates are shown in degrees, minutes and seconds
 * @param grid whether the grid begins shown
 * @param list whether the list of layers is seen
 */
public record GpsOptions(
    boolean follow, String followed, Optional<GeoPoint> origin, Map<String, Object> beginnings, boolean sexagesimal,
    boolean grid,
    boolean list) {
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
  public static final String LIST = "list";

  private static final double LONGEST_MINUTES = 100_000;

  /** What the view can be configured with, whichever layers there are. */
  public static Schema schema() {
    return schema(List.of());
  }

  /** The same with kinds of layers to choose from. */
  static Schema schema(List<DisplayKind> kinds) {
    return Schema.of(
        Setting.of(FOLLOW, new ValueType.Flag(), false, "Keep a receiver in the middle."),
        Setting.of(FOLLOWED, new ValueType.Text(TextRule.SOURCE.orEmpty("\"\"")), "",
            "Which receiver is followed, as component.port; empty for the first."),
        Setting.of(ORIGIN, new ValueType.Choice(List.of(FIRST_FIX, FIXED)), FIRST_FIX,
            "Where metres are counted from: the first fix, or origin_latitude and origin_longitude."),
        Setting.of(ORIGIN_LATITUDE, new ValueType.Num(-90, 90, "\u00b0"), 0.0, "Degrees, north is positive."),
        Setting.of(ORIGIN_LONGITUDE, new ValueType.Num(-180, 180, "\u00b0"), 0.0, "Degrees, east is positive."),
        Setting.of(TRAIL_MINUTES, new ValueType.Num(0, LONGEST_MINUTES, "min"), 240.0, "How long tracks are kept."),
        Setting.of(WAY_COLORS, new ValueType.Choice(List.of("auto", "receiver", "quality")), "auto",
            "Colour of tracks: by quality of the fixes, by receiver, or auto: by quality where there is one receiver."),
        Setting.of(COORDINATES, new ValueType.Choice(List.of(DECIMAL, DMS)), DECIMAL,
            "Show coordinates in degrees, or in degrees, minutes and seconds."),
        Setting.of(SHOW_GRID, new ValueType.Flag(), true, "Show the grid."),
        Setting.of(LayerStack.LAYERS, DisplayEntry.list("layer", "receiver", kinds), List.of(),
            "Layers, the topmost first; the settings above say how those begin that are not listed."),
        Setting.of(DisplayEntry.AUTOMATIC, new ValueType.Flag(), true,
            "Show what robots offer beside the layers that are listed."),
        KeptViewport.setting(),
        Setting.of(LIST, new ValueType.Flag(), false, "Whether the list of layers is seen."));
  }

  /** Reads checked settings. */
  public static GpsOptions of(Settings s) {
    Optional<GeoPoint> origin = s.text(ORIGIN).equals(FIXED)
        ? Optional.of(GeoPoint.degrees(s.number(ORIGIN_LATITUDE), s.number(ORIGIN_LONGITUDE)))
        : Optional.empty();
    Map<String, Object> beginnings = Map.of(TRAIL_MINUTES, s.number(TRAIL_MINUTES), WAY_COLORS, s.text(WAY_COLORS));
    return new GpsOptions(s.flag(FOLLOW), s.text(FOLLOWED), origin, beginnings, s.text(COORDINATES).equals(DMS),
        s.flag(SHOW_GRID), s.flag(LIST));
  }

  /** A layer that nobody has listed, as the settings have it begin. */
  public DisplaySpec begin(DisplaySpec spec) {
    return switch (spec.type()) {
      case "receiver" -> spec.named("").with(beginnings);
      case "grid" -> spec.show(grid);
      default -> spec;
    };
  }
}
