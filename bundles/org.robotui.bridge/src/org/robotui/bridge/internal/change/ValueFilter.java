package org.robotui.bridge.internal.change;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.robotui.api.config.Settings;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.condition.Condition;
import org.robotui.condition.Conditions;
import org.robotui.condition.Signals;
import org.robotui.condition.SourceName;
import org.robotui.condition.Verdict;
import org.robotui.data.Data;
import org.robotui.data.DataType;
import org.robotui.data.status.LogEntry;

/** Lets values pass that meet a condition. The condition may remember what it has seen: for one thread. */
public final class ValueFilter {
  private final Condition condition;
  private final SourceId port;

  private ValueFilter(Condition condition, SourceId port) {
    this.condition = condition;
    this.port = port;
  }

  /** As configured, for the values of a port; none where all pass. */
  public static Optional<ValueFilter> of(Settings settings, SourceId port) {
    return settings.has("when") ? Optional.of(new ValueFilter(Conditions.parse(settings.text("when"), 0), port))
        : Optional.empty();
  }

  /**
   * Whether a value meets it.
   *
   * @throws IllegalArgumentException where that cannot be told of such a value, with what is missing
   */
  public boolean passes(Envelope<?> envelope) {
    return switch (condition.check(new OneValue(port, envelope), false)) {
      case Verdict.Holds holds -> true;
      case Verdict.Fails fails -> false;
      case Verdict.Unknown unknown -> throw new IllegalArgumentException("'when': " + unknown.reason());
    };
  }

  /** All that conditions see is the value. */
  private record OneValue(SourceId port, Envelope<?> envelope) implements Signals {
    @Override
    public List<Reading> readings(SourceName name) {
      return name.fits(port) ? List.of(reading(name.text())) : List.of();
    }

    @Override
    public List<Reading> readings(String typeName) {
      return DataType.of(envelope.value().getClass()).name().equals(typeName) ? List.of(reading(port.port()))
          : List.of();
    }

    private Reading reading(String name) {
      List<Envelope<? extends Data>> newest = List.of(envelope);
      return new Reading(name, new InputState.Live(0, envelope.ageSeconds(System.nanoTime())), newest,
          OptionalDouble.empty());
    }

    @Override
    public List<LogEntry> log() {
      return envelope.value() instanceof LogEntry entry ? List.of(entry) : List.of();
    }

    @Override
    public LinkState link() {
      return new LinkState.Connected(port.component());
    }
  }
}
