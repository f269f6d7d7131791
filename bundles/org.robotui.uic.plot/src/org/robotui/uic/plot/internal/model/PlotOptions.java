package org.robotui.uic.plot.internal.model;

import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.TextRule;
import org.robotui.api.config.ValueType;
import org.robotui.data.record.FieldPath;
import org.robotui.uic.plot.internal.signal.Expr;
import org.robotui.uic.plot.internal.signal.ExprParser;

/** What the plot can be configured with. */
public final class PlotOptions {
  public static final String AXES = "axes";
  public static final String SIGNALS = "signals";
  public static final String WINDOW = "window";
  public static final String TIME = "time";
  public static final String LINKED = "linked";
  public static final String STYLE = "style";
  public static final String LEGEND = "legend";
  public static final String MEMORY = "memory";
  public static final String GAP = "gap";

  public static final String BY_STAMP = "stamp";
  public static final String BY_RECEIPT = "received";

  /** The words of the colours, in the order of the theme's trace colours. */
  public static final List<String> COLOURS = List.of("blue", "orange", "green", "purple", "brown", "pink", "grey");

  static final String NAME = "name";
  static final String TRACES = "traces";
  static final String X = "x";
  static final String RANGE = "range";
  static final String RANGE_X = "range_x";
  static final String RANGE_RIGHT = "range_right";
  static final String SIGNAL = "signal";
  static final String SOURCE = "source";
  static final String PATH = "path";
  static final String DERIVE = "derive";
  static final String LABEL = "label";
  static final String UNIT = "unit";
  static final String COLOUR = "colour";
  static final String SCALE = "scale";
  static final String RIGHT = "right";
  static final String LEFT = "left";
  static final String HIDDEN = "hidden";

  private static final Pattern NAMES = Pattern.compile("[A-Za-z_]\\w*");
  private static final double MOST = 1e300;
  private static final ValueType TEXT = new ValueType.Text();
  private static final ValueType SIGNAL_TEXT =
      new ValueType.Text(
          TextRule.readBy("a signal, such as base.odom:linear.x, or a function of signals", PlotOptions::read));
  private static final TextRule FIELD =
      TextRule.readBy("the path of a field, such as linear.x or ranges[3]", FieldPath::parse);
  private static final ValueType FUNCTION = new ValueType.Text(TextRule.readBy(
      "a function, such as derivative or average(0.5)",
      text -> ExprParser.parse(PlotCodec.applied(text.strip(), "any.port:x"))));

  private static final Schema TRACE = Schema.of(
      Setting.optional(SIGNAL, SIGNAL_TEXT,
          "What it shows: SOURCE:PATH, for example base./odom:linear.x, what is calculated with + - * / and parentheses, a name of signals, or a function: derivative(s), integral(s), "
              + "average(s, seconds), lowpass(s, hertz), scale(s, factor, offset), difference(s, t), norm(s, t, ...), roll(q), pitch(q), yaw(q), unwrap(s)."),
      Setting.optional(SOURCE, new ValueType.Text(TextRule.SOURCE),
          "In place of signal: component.port, for example base./odom."),
      Setting.optional(PATH, new ValueType.Text(FIELD), "With source: the field, for example linear.x or ranges[3]."),
      Setting.of(DERIVE, new ValueType.AnyOf(List.of(FUNCTION, new ValueType.ListOf(FUNCTION))), List.of(),
          "Functions of that, the first applied first: derivative, integral, average(0.5), scale(2, 1)."),
      Setting.optional(LABEL, TEXT, "The name in the legend."),
      Setting.optional(UNIT, TEXT, "The unit, where none is known."),
      Setting.optional(COLOUR, new ValueType.Choice(COLOURS), "Its colour; without, the first that is free."),
      Setting.optional(STYLE, new ValueType.Choice(LineStyle.words()), "How its samples are joined."),
      Setting.of(SCALE, new ValueType.Choice(List.of(LEFT, RIGHT)), LEFT, "The scale to which it belongs."),
      Setting.of(HIDDEN, new ValueType.Flag(), false, "Listed, but not drawn."));

  private static final Schema NAMED = Schema.of(
      Setting.required(NAME, new ValueType.Text(TextRule.matching("a word of letters, digits and _", "[A-Za-z_]\\w*")),
          "By which others name it."),
      Setting.required(SIGNAL, SIGNAL_TEXT, "What it means; it may have the names that stand before it."),
      Setting.optional(UNIT, TEXT, "The unit, where none is known."));

  private static final ValueType RANGE_TYPE = new ValueType.AnyOf(List.of(
      new ValueType.Choice(List.of(YRange.AUTO, YRange.HOLD)),
      new ValueType.ListOf(new ValueType.Num(-MOST, MOST, ""))));

  private static final Schema AXIS = Schema.of(
      Setting.of(TRACES, new ValueType.ListOf(new ValueType.AnyOf(List.of(SIGNAL_TEXT, new ValueType.Section(TRACE)))),
          List.of(), "The traces, each a signal or a group."),
      Setting.optional(X, SIGNAL_TEXT,
          "The signal over which the traces are shown, for example base./odom:pose.translation.x; without, that is time."),
      Setting.of(RANGE_X, RANGE_TYPE, YRange.AUTO, "With x: its scale."),
      Setting.of(RANGE, RANGE_TYPE, YRange.AUTO, "The left scale: auto, hold (never shrinks), or [low, high]."),
      Setting.of(RANGE_RIGHT, RANGE_TYPE, YRange.AUTO, "The right scale."));

  private static final Schema SCHEMA = Schema.of(
      Setting.of(SIGNALS, new ValueType.ListOf(new ValueType.Section(NAMED)), List.of(),
          "Signals that have names, so that traces and each other can be made of them."),
      Setting.of(AXES, new ValueType.ListOf(new ValueType.Section(AXIS)), List.of(), "The axes from top to bottom."),
      Setting.of(WINDOW, new ValueType.Num(0, 1e6, "s"), 60.0, "How much time is seen while live; 0 for all."),
      Setting.of(TIME, new ValueType.Choice(List.of(BY_STAMP, BY_RECEIPT)), BY_STAMP,
          "By whose time values are placed: that of their stamps, or that of their receipt."),
      Setting.of(LINKED, new ValueType.Flag(), true, "Whether all axes show the same time."),
      Setting.of(STYLE, new ValueType.Choice(LineStyle.words()), LineStyle.LINE.word(), "How samples are joined."),
      Setting.of(LEGEND, new ValueType.Choice(List.of("auto", "side", "top", "off")), "auto",
          "Where names and figures stand; auto takes the side where there is room."),
      Setting.of(MEMORY, new ValueType.Int(1_000, 50_000_000), 1_000_000L,
          "Samples kept of each trace; 16 bytes each and a little more."),
      Setting.of(GAP, new ValueType.Num(0, 86_400, "s"), 1.0,
          "A line breaks where nothing came for longer than this and than five of its usual intervals; 0 never breaks it."));

  private PlotOptions() {}

  /** What names mean is known to all settings together. */
  private static void read(String text) {
    Expr any = ExprParser.parse("any.port:x");
    ExprParser.parse(text, name -> NAMES.matcher(name).matches() ? Optional.of(any) : Optional.empty());
  }

  public static Schema schema() {
    return SCHEMA;
  }
}
