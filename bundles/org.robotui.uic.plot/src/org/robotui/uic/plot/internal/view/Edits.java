package org.robotui.uic.plot.internal.view;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.robotui.api.config.SettingsStore;
import org.robotui.uic.plot.internal.model.NamedSignal;
import org.robotui.uic.plot.internal.model.PlotCodec;
import org.robotui.uic.plot.internal.model.PlotOptions;
import org.robotui.uic.plot.internal.model.PlotSpec;
import org.robotui.uic.plot.internal.model.SignalNames;
import org.robotui.uic.plot.internal.model.TraceRef;
import org.robotui.uic.plot.internal.model.TraceSpec;

/** Changes what is configured; the settings keep it. */
public final class Edits {
  /** Between a signal and the one over which it is shown. */
  static final String OVER = " over ";

  private final SettingsStore settings;

  public Edits(SettingsStore settings) {
    this.settings = settings;
  }

  public PlotSpec spec() {
    return PlotCodec.read(settings.current());
  }

  /** Changes the axes. */
  public void axes(UnaryOperator<PlotSpec> change) {
    PlotSpec before = spec();
    PlotSpec after = change.apply(before);
    if (!after.axes().equals(before.axes())) {
      settings.set(PlotOptions.AXES, PlotCodec.write(after.axes()));
    }
  }

  /** Changes another setting. */
  public void set(String name, Object value) {
    settings.set(name, value);
  }

  /** Shows an axis over a signal; says what is wrong, if anything. */
  Optional<String> over(String signal, int axis) {
    try {
      String read = read(signal.strip());
      axes(spec -> spec.withAxis(axis, a -> a.over(Optional.of(read))));
      return Optional.empty();
    } catch (IllegalArgumentException e) {
      return Optional.of(e.getMessage());
    }
  }

  /** What a text means, as it is kept. */
  private String read(String text) {
    return new SignalNames(spec().names()).read(text).toString();
  }

  /** What is wrong with a text that is typed, if anything. */
  Optional<String> fault(String text) {
    try {
      int over = text.indexOf(OVER);
      if (over >= 0) {
        read(text.substring(over + OVER.length()));
      }
      read(over < 0 ? text : text.substring(0, over));
      return Optional.empty();
    } catch (IllegalArgumentException e) {
      return Optional.of(e.getMessage());
    }
  }

  /** Gives the signal of a trace a name, by which others can be made of it. */
  void name(TraceRef ref, String name) {
    spec().trace(ref).ifPresent(trace -> {
      List<NamedSignal> names = new ArrayList<>(spec().names());
      names.add(new NamedSignal(name, trace.signal(), trace.unit()));
      settings.set(PlotOptions.SIGNALS, PlotCodec.writeNames(names));
      axes(s -> s.with(ref, t -> t.named(name)));
    });
  }

  /** Adds one signal over another. */
  void curve(String signal, String x) {
    axes(spec -> spec.plusCurve(x, TraceSpec.of(signal)));
  }

  /** One over another: {@code base./odom:pose.translation.y over base./odom:pose.translation.x}. */
  private PlotSpec plus(PlotSpec spec, int axis, String line) {
    int over = line.indexOf(OVER);
    if (over < 0) {
      return spec.plus(axis, TraceSpec.of(read(line)));
    }
    return spec.plusCurve(read(line.substring(over + OVER.length())),
        TraceSpec.of(read(line.substring(0, over))));
  }

  /**
   * Adds traces, one a line, each a signal or one over another; nothing where one of them cannot be read.
   *
   * @param axis to which; a new one where there are fewer
   * @return what is wrong, if anything
   */
  public Optional<String> add(String text, int axis) {
    List<String> lines = text.lines().map(String::strip).filter(l -> !l.isEmpty()).toList();
    try {
      axes(spec -> {
        PlotSpec more = spec;
        for (String line : lines) {
          more = plus(more, axis, line);
        }
        return more;
      });
      return lines.isEmpty() ? Optional.of("there is no text in it") : Optional.empty();
    } catch (IllegalArgumentException e) {
      return Optional.of(e.getMessage());
    }
  }
}
