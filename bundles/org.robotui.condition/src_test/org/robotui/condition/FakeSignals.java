package org.robotui.condition;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.data.Data;
import org.robotui.data.sensor.Battery;
import org.robotui.data.status.LogEntry;
import org.robotui.data.status.Severity;

/** What a robot said, in a test's hands. */
final class FakeSignals implements Signals {
  static final InputState LIVE = new InputState.Live(10, 0);

  private final List<LogEntry> log = new ArrayList<>();
  private final List<Reading> readings = new ArrayList<>();
  private LinkState link = new LinkState.Disconnected();
  private String type = "";

  FakeSignals battery(double charge) {
    return put("battery", LIVE, new Battery(12, -1, charge, Battery.Status.DISCHARGING));
  }

  FakeSignals put(String name, InputState state, Data value) {
    readings.removeIf(reading -> reading.name().equals(name));
    Envelope<Data> envelope =
        new Envelope<>(value, new SourceId("base", name), 0, Optional.empty(), 0, Optional.empty());
    readings.add(new Reading(name, state, List.of(envelope), OptionalDouble.empty()));
    type = value.getClass().getSimpleName();
    return this;
  }

  FakeSignals state(String name, InputState state) {
    readings.replaceAll(
        reading -> reading.name().equals(name) ? new Reading(name, state, reading.newest(), OptionalDouble.empty())
            : reading);
    return this;
  }

  FakeSignals delay(String name, double seconds) {
    readings.replaceAll(reading -> reading.name().equals(name)
        ? new Reading(name, reading.state(), reading.newest(), OptionalDouble.of(seconds))
        : reading);
    return this;
  }

  FakeSignals gone(String name) {
    readings.removeIf(reading -> reading.name().equals(name));
    return this;
  }

  FakeSignals link(LinkState next) {
    link = next;
    return this;
  }

  FakeSignals logs(Severity... severities) {
    log.clear();
    for (Severity severity : severities) {
      log.add(new LogEntry(severity, "/planner", "no way to the goal", "plan.cpp:12"));
    }
    return this;
  }

  @Override
  public List<Reading> readings(SourceName name) {
    return readings.stream().filter(reading -> name.fits(new SourceId("base", reading.name()))).toList();
  }

  @Override
  public List<Reading> readings(String typeName) {
    return typeName.equals(type) ? List.copyOf(readings) : List.of();
  }

  @Override
  public List<LogEntry> log() {
    return List.copyOf(log);
  }

  @Override
  public LinkState link() {
    return link;
  }
}
