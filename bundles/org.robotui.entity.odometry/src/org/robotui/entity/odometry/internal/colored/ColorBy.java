package org.robotui.entity.odometry.internal.colored;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.TextRule;
import org.robotui.api.config.ValueType;
import org.robotui.api.port.SourceId;
import org.robotui.api.port.StreamField;
import org.robotui.gl.display.ColorScale;
import org.robotui.gl.shape.ColorRamp;

/**
 * By which value a way is coloured, and how.
 *
 * @param field the value; none where the way has one colour
 * @param ramp the colours from the least to the greatest value
 * @param reversed whether they begin with their last
 * @param min the value of the first colour; none for the least there is
 * @param max the value of the last colour; none for the greatest there is
 * @param whole whether the whole way of a recording is shown
 */
public record ColorBy(Optional<StreamField> field, ColorRamp ramp, boolean reversed, Optional<Double> min,
    Optional<Double> max, boolean whole) {
  private static final String FIELD = "color_by";
  private static final double MOST = 1e12;
  private static final List<Setting> SETTINGS = List.of(
      Setting.of(FIELD, new ValueType.Text(TextRule
          .readBy("a field, such as base./odom:linear.x", text -> StreamField.parse(text.strip())).orEmpty("\"\"")), "",
          "The value that colours the way, as in plots: SOURCE:PATH, for example base./odom:linear.x; without, it has one colour."),
      Setting.of("colors", new ValueType.Choice(ColorRamp.ids()), ColorRamp.TURBO.id(),
          "With color_by: the colours from the least to the greatest value."),
      Setting.of("reverse", new ValueType.Flag(), false, "Whether the colours begin with their last."),
      Setting.optional("min", new ValueType.Num(-MOST, MOST, ""),
          "The value of the first colour; without it, the least on the way."),
      Setting.optional("max", new ValueType.Num(-MOST, MOST, ""),
          "The value of the last colour; without it, the greatest on the way."),
      Setting.of("whole", new ValueType.Flag(), true,
          "With color_by: whether all of the way is shown that a recording has, and not only what was played."));

  /** Settings, and those of colours by a value. */
  public static Schema with(Setting... others) {
    return Schema.of(Stream.concat(Stream.of(others), SETTINGS.stream()).toArray(Setting[]::new));
  }

  /** Reads settings that have those of {@link #with}; where they have none, the way has one colour. */
  public static ColorBy of(Settings s) {
    if (!s.values().containsKey(FIELD) || s.text(FIELD).isBlank()) {
      return new ColorBy(Optional.empty(), ColorRamp.TURBO, false, Optional.empty(), Optional.empty(), false);
    }
    return new ColorBy(StreamField.read(s.text(FIELD).strip()), ColorRamp.named(s.text("colors")), s.flag("reverse"),
        limit(s, "min"), limit(s, "max"), s.flag("whole"));
  }

  private static Optional<Double> limit(Settings s, String name) {
    return s.has(name) ? Optional.of(s.number(name)) : Optional.empty();
  }

  /** Where the value comes from. */
  public static Set<SourceId> source(Settings s) {
    return of(s).field.stream().map(StreamField::source).collect(Collectors.toSet());
  }

  /** What the colours of a way mean, given the unit of the value; none where there is no value and no limit. */
  Optional<ColorScale> scale(WayPoints way, String unit) {
    double[] known = Arrays.stream(way.values()).filter(Double::isFinite).toArray();
    double low = min.orElseGet(() -> Arrays.stream(known).min().orElse(Double.NaN));
    double high = max.orElseGet(() -> Arrays.stream(known).max().orElse(Double.NaN));
    return Double.isNaN(low) || Double.isNaN(high) ? Optional.empty()
        : Optional.of(new ColorScale(field.map(f -> f.path().toString()).orElse(""), unit, Math.min(low, high),
            Math.max(low, high), ramp, reversed));
  }
}
