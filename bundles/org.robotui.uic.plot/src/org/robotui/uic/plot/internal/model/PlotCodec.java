package org.robotui.uic.plot.internal.model;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import org.robotui.api.config.Settings;

/** Reads what is shown from the settings, and writes it back in the form in which they are kept. */
public final class PlotCodec {
  private PlotCodec() {}

  public static PlotSpec read(Settings settings) {
    return new PlotSpec(
        settings.list(PlotOptions.AXES).stream().map(PlotCodec::axis).toList(),
        settings.number(PlotOptions.WINDOW),
        PlotOptions.BY_STAMP.equals(settings.text(PlotOptions.TIME)),
        settings.flag(PlotOptions.LINKED),
        LineStyle.of(settings.text(PlotOptions.STYLE)),
        PlotSpec.LegendPlace.valueOf(settings.text(PlotOptions.LEGEND).toUpperCase(Locale.ROOT)),
        names(settings));
  }

  private static List<NamedSignal> names(Settings settings) {
    return settings.list(PlotOptions.SIGNALS).stream().map(PlotCodec::fields).map(fields -> new NamedSignal(
        text(fields, PlotOptions.NAME).orElse(""), text(fields, PlotOptions.SIGNAL).orElse(""),
        text(fields, PlotOptions.UNIT))).toList();
  }

  /** Names as the setting holds them. */
  public static List<Object> writeNames(List<NamedSignal> names) {
    return names.stream().<Object>map(named -> {
      Map<String, Object> written = new LinkedHashMap<>();
      written.put(PlotOptions.NAME, named.name());
      written.put(PlotOptions.SIGNAL, named.signal());
      named.unit().ifPresent(unit -> written.put(PlotOptions.UNIT, unit));
      return written;
    }).toList();
  }

  /** What is wrong with axes whose parts fit the schema. */
  public static List<String> faults(Settings settings) {
    SignalNames names = new SignalNames(names(settings));
    List<String> faults = new ArrayList<>(names.faults());
    for (Object axis : settings.list(PlotOptions.AXES)) {
      Map<String, Object> fields = fields(axis);
      list(fields.get(PlotOptions.TRACES)).stream().map(PlotCodec::trace)
          .forEach(t -> Signal.of(t.signal(), names).error().ifPresent(faults::add));
      text(fields, PlotOptions.X).ifPresent(x -> Signal.of(x, names).error().ifPresent(e -> faults.add("x: " + e)));
      for (String range : List.of(PlotOptions.RANGE, PlotOptions.RANGE_RIGHT, PlotOptions.RANGE_X)) {
        if (fields.get(range) instanceof List<?> limits && range(fields, range) instanceof YRange.Auto) {
          faults.add("'" + range + "' must be [low, high], the lower number first, not " + limits);
        }
      }
    }
    return faults;
  }

  /** The axes as the setting holds them: only what is not as it would be without. */
  public static List<Object> write(List<AxisSpec> axes) {
    return axes.stream().<Object>map(PlotCodec::write).toList();
  }

  private static Map<String, Object> write(AxisSpec axis) {
    Map<String, Object> written = new LinkedHashMap<>();
    written.put(PlotOptions.TRACES, axis.traces().stream().map(PlotCodec::write).toList());
    axis.x().ifPresent(x -> written.put(PlotOptions.X, x));
    write(written, PlotOptions.RANGE, axis.left());
    write(written, PlotOptions.RANGE_RIGHT, axis.right());
    write(written, PlotOptions.RANGE_X, axis.across());
    return written;
  }

  private static void write(Map<String, Object> written, String name, YRange range) {
    if (!(range instanceof YRange.Auto)) {
      written.put(name, range.toSetting());
    }
  }

  private static Object write(TraceSpec trace) {
    if (trace.equals(TraceSpec.of(trace.signal()))) {
      return trace.signal();
    }
    Map<String, Object> written = new LinkedHashMap<>();
    written.put(PlotOptions.SIGNAL, trace.signal());
    trace.label().ifPresent(label -> written.put(PlotOptions.LABEL, label));
    trace.unit().ifPresent(unit -> written.put(PlotOptions.UNIT, unit));
    trace.colour().ifPresent(colour -> written.put(PlotOptions.COLOUR, PlotOptions.COLOURS.get(colour)));
    trace.style().ifPresent(style -> written.put(PlotOptions.STYLE, style.word()));
    if (trace.right()) {
      written.put(PlotOptions.SCALE, PlotOptions.RIGHT);
    }
    if (trace.hidden()) {
      written.put(PlotOptions.HIDDEN, true);
    }
    return written;
  }

  private static AxisSpec axis(Object value) {
    Map<String, Object> fields = fields(value);
    List<TraceSpec> traces = list(fields.get(PlotOptions.TRACES)).stream().map(PlotCodec::trace).toList();
    return new AxisSpec(traces, range(fields, PlotOptions.RANGE), range(fields, PlotOptions.RANGE_RIGHT),
        text(fields, PlotOptions.X), range(fields, PlotOptions.RANGE_X));
  }

  private static YRange range(Map<String, Object> fields, String name) {
    return YRange.ofSetting(fields.getOrDefault(name, YRange.AUTO));
  }

  private static TraceSpec trace(Object value) {
    if (value instanceof String signal) {
      return TraceSpec.of(signal);
    }
    Map<String, Object> fields = fields(value);
    return new TraceSpec(
        signal(fields),
        text(fields, PlotOptions.LABEL),
        text(fields, PlotOptions.UNIT),
        text(fields, PlotOptions.COLOUR).map(c -> OptionalInt.of(PlotOptions.COLOURS.indexOf(c)))
            .orElse(OptionalInt.empty()),
        text(fields, PlotOptions.STYLE).map(LineStyle::of),
        text(fields, PlotOptions.SCALE).filter(PlotOptions.RIGHT::equals).isPresent(),
        Boolean.TRUE.equals(fields.get(PlotOptions.HIDDEN)));
  }

  private static String signal(Map<String, Object> fields) {
    String signal = text(fields, PlotOptions.SIGNAL)
        .orElseGet(() -> text(fields, PlotOptions.SOURCE).orElse("") + ":" + text(fields, PlotOptions.PATH).orElse(""));
    for (Object function : list(fields.get(PlotOptions.DERIVE))) {
      signal = applied(function.toString().strip(), signal);
    }
    return signal;
  }

  /** {@code average(0.5)} of {@code s} is {@code average(s, 0.5)}. */
  static String applied(String function, String signal) {
    int open = function.indexOf('(');
    if (open < 0) {
      return function + "(" + signal + ")";
    }
    return function.substring(0, open + 1) + signal + ", " + function.substring(open + 1);
  }

  private static Optional<String> text(Map<String, Object> fields, String name) {
    return Optional.ofNullable(fields.get(name)).map(Object::toString).map(String::strip).filter(t -> !t.isEmpty());
  }

  private static List<?> list(Object value) {
    return switch (value) {
      case List<?> l -> l;
      case String s -> List.of(s);
      case null, default -> new ArrayList<>();
    };
  }

  private static Map<String, Object> fields(Object value) {
    if (value instanceof Settings settings) {
      return settings.values();
    }
    Map<String, Object> fields = new LinkedHashMap<>();
    ((Map<?, ?>) value).forEach((name, field) -> fields.put(name.toString(), field));
    return fields;
  }
}
