package org.robotui.uic.text.internal;

import java.util.List;
import java.util.Optional;
import org.robotui.api.TextUic;
import org.robotui.api.UicContext;
import org.robotui.api.config.Settings;
import org.robotui.api.port.Input;
import org.robotui.data.Data;

/** The view: the tick looks, the terminal's thread lays out. */
final class TextView implements TextUic {
  private final UicContext context;
  private final Input<Data> all;
  private volatile Optional<Report> report = Optional.empty();

  TextView(UicContext context) {
    this.context = context;
    this.all = context.input(TextType.ALL);
  }

  @Override
  public boolean tick(long nowNanos) {
    all.drain(envelope -> {}); // what is shown are rates and newest values, which core keeps
    Settings settings = context.settings().current();
    Optional<Report> next = Optional.of(new Report(context.ruic().snapshot(), Standing.of(context.ruic().authorities()),
        Alarms.of(context.ruic().alerts()),
        settings.flag(TextType.UNUSED), settings.flag(TextType.TYPES)));
    boolean changed = !next.equals(report);
    report = next;
    return changed;
  }

  @Override
  public List<String> lines(int columns, int rows) {
    return report.map(r -> r.lines(columns, rows)).orElse(List.of());
  }

  @Override
  public void close() {
    // Nothing is held but memory.
  }
}
