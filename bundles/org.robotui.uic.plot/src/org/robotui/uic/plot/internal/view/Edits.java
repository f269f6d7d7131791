package org.robotui.uic.plot.internal.view;

import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.robotui.api.config.SettingsStore;
import org.robotui.uic.plot.internal.model.PlotCodec;
import org.robotui.uic.plot.internal.model.PlotOptions;
import org.robotui.uic.plot.internal.model.PlotSpec;
import org.robotui.uic.plot.internal.model.TraceSpec;
import org.robotui.uic.plot.internal.signal.ExprParser;

/** Changes what is configured; the settings keep it. */
public final class Edits {
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

  /**
   * Adds traces, one a line; nothing where one of them cannot be read.
   *
   * @param axis to which; a new one where there are fewer
   * @return what is wrong, if anything
   */
  public Optional<String> add(String text, int axis) {
    List<String> lines = text.lines().map(String::strip).filter(l -> !l.isEmpty()).toList();
    try {
      List<String> signals = lines.stream().map(l -> ExprParser.parse(l).toString()).toList();
      axes(spec -> {
        PlotSpec more = spec;
        for (String signal : signals) {
          more = more.plus(axis, TraceSpec.of(signal));
        }
        return more;
      });
      return signals.isEmpty() ? Optional.of("there is no text in it") : Optional.empty();
    } catch (IllegalArgumentException e) {
      return Optional.of(e.getMessage());
    }
  }
}
