package org.robotui.uic.camera.internal;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.ValueType;
import org.robotui.entity.image.ColorMap;
import org.robotui.entity.image.Rendering;
import org.robotui.entity.image.Span;

/**
 * The settings of the camera view.
 *
 * @param smooth whether pixels are smoothed when the picture is scaled
 * @param zoom how large it is when nobody has zoomed
 * @param rendering how numbers become colours
 * @param readOut whether the pixel under the pointer is told
 * @param details whether size, encoding, rate and age are told
 * @param legend whether the colours of numbers are explained
 */
record CameraOptions(boolean smooth, ZoomMode zoom, Rendering rendering, boolean readOut, boolean details,
    boolean legend) {
  static final String SMOOTH = "smooth";
  static final String ZOOM = "zoom";
  static final String COLOR_MAP = "color_map";
  static final String REVERSED = "color_map_reversed";
  static final String RANGE = "range";
  static final String RANGE_MIN = "range_min";
  static final String RANGE_MAX = "range_max";
  static final String DEPTH = "depth";
  static final String READ_OUT = "read_out";
  static final String DETAILS = "details";
  static final String LEGEND = "legend";
  static final String AUTO = "auto";
  static final String FIXED = "fixed";

  private static final ValueType FLAG = new ValueType.Flag();
  private static final ValueType NUMBER = new ValueType.Num(-1e9, 1e9, "");

  static Schema schema() {
    List<String> maps = new ArrayList<>(List.of(AUTO));
    Arrays.stream(ColorMap.values()).map(ColorMap::id).forEach(maps::add);
    return Schema.of(
        Setting.of(SMOOTH, FLAG, true,
            "Whether pixels are smoothed when the picture is scaled; close up they are always shown as they are."),
        Setting.of(ZOOM, new ValueType.Choice(ZoomMode.ids()), ZoomMode.FIT.id(),
            "How large the picture is: all of it, the whole view, or a pixel on a pixel."),
        Setting.of(COLOR_MAP, new ValueType.Choice(maps), AUTO,
            "The colours of pictures of numbers; 'auto' is grey for brightness and turbo else."),
        Setting.of(REVERSED, FLAG, false, "Reverse the colour map: the smallest number gets the last colour."),
        Setting.of(RANGE, new ValueType.Choice(List.of(AUTO, FIXED)), AUTO,
            "Whether the colours follow the numbers or span range_min to range_max."),
        Setting.of(RANGE_MIN, NUMBER, 0.0, "The number of the first colour, metres for depth."),
        Setting.of(RANGE_MAX, NUMBER, 10.0, "The number of the last colour, metres for depth."),
        Setting.of(DEPTH, FLAG, true,
            "Whether 16UC1 and 32FC1 are depth in millimetres and metres; else plain numbers."),
        Setting.of(READ_OUT, FLAG, true, "Tell place, value and colour of the pixel under the pointer."),
        Setting.of(DETAILS, FLAG, false, "Tell size, encoding, rate, age and frame of the pictures."),
        Setting.of(LEGEND, FLAG, true, "Explain the colours of pictures of numbers."));
  }

  static CameraOptions of(Settings s) {
    String map = s.text(COLOR_MAP);
    Optional<ColorMap> chosen =
        map.equals(AUTO) ? Optional.empty() : Optional.of(ColorMap.valueOf(map.toUpperCase(Locale.ROOT)));
    Rendering rendering = new Rendering(chosen, s.flag(REVERSED), range(s), s.flag(DEPTH));
    return new CameraOptions(
        s.flag(SMOOTH), ZoomMode.of(s.text(ZOOM)), rendering, s.flag(READ_OUT), s.flag(DETAILS), s.flag(LEGEND));
  }

  /** A range that is none, because only one end was written, follows the pictures. */
  private static Optional<Span> range(Settings s) {
    double low = s.number(RANGE_MIN);
    double high = s.number(RANGE_MAX);
    return s.text(RANGE).equals(FIXED) && low < high ? Optional.of(new Span(low, high)) : Optional.empty();
  }
}
