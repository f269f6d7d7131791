package org.robotui.uic.sound.internal;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.robotui.api.host.RuicView;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.Input;
import org.robotui.api.port.SourceId;
import org.robotui.api.time.RobotClock;
import org.robotui.condition.Signals;
import org.robotui.condition.SourceName;
import org.robotui.data.Data;
import org.robotui.data.Stamp;
import org.robotui.data.status.LogEntry;

/** What the alerts look at, asked of the robot only as far as they need it. The thread of the tick. */
final class RobotSignals implements Signals {
  private final Input<Data> input;
  private final RuicView ruic;
  private final Predicate<Input.Candidate> needed;
  private final List<LogEntry> log = new ArrayList<>();
  private List<Input.Candidate> chosen = List.of();

  RobotSignals(Input<Data> input, RuicView ruic, Predicate<Input.Candidate> needed) {
    this.input = input;
    this.ruic = ruic;
    this.needed = needed;
  }

  /** Takes what came since the last time. */
  void take() {
    choose();
    log.clear();
    input.drain(envelope -> {
      if (envelope.value() instanceof LogEntry entry) {
        log.add(entry);
      }
    });
  }

  private void choose() {
    List<Input.Candidate> wanted = input.candidates().stream().filter(needed).toList();
    if (!wanted.equals(chosen)) {
      chosen = wanted;
      input.choose(wanted.stream().map(Input.Candidate::id).collect(Collectors.toUnmodifiableSet()));
    }
  }

  @Override
  public List<Reading> readings(SourceName name) {
    return chosen.stream().map(Input.Candidate::id).filter(name::fits).map(this::reading).toList();
  }

  @Override
  public List<Reading> readings(String typeName) {
    return chosen.stream().filter(c -> c.typeName().equals(typeName)).map(Input.Candidate::id).map(this::reading)
        .toList();
  }

  private Reading reading(SourceId id) {
    List<Envelope<? extends Data>> newest =
        input.latest(id).stream().<Envelope<? extends Data>>map(envelope -> envelope).toList();
    return new Reading(id.port(), input.state(id), newest,
        newest.stream().mapToDouble(this::delay).filter(Double::isFinite).findFirst());
  }

  /** By the clock of the robot, as far as stamps are of it; not a number where they are not. */
  private double delay(Envelope<? extends Data> envelope) {
    RobotClock clock = ruic.clock();
    long nanos = System.nanoTime();
    Stamp now = clock.now();
    double age = clock.ageSeconds(envelope.receivedNanos(), nanos);
    return envelope.stamp().filter(stamp -> stamp.clock() == now.clock())
        .map(stamp -> (now.nanos() - stamp.nanos()) * 1e-9 - age).orElse(Double.NaN);
  }

  @Override
  public List<LogEntry> log() {
    return List.copyOf(log);
  }

  @Override
  public LinkState link() {
    return ruic.snapshot().link();
  }
}
