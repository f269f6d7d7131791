package org.robotui.rfic.recording.internal.find;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Input;
import org.robotui.api.replay.RecordedValue;
import org.robotui.condition.Signals;
import org.robotui.condition.SourceName;
import org.robotui.data.status.LogEntry;

/** What a recorded robot has said until a time. For one thread. */
final class RecordedSignals implements Signals {
  private final Map<String, RecordedSource> sources = new LinkedHashMap<>();
  private final List<LogEntry> log = new ArrayList<>();
  private long now;

  /** Nothing was said yet. */
  RecordedSignals(List<Input.Candidate> candidates, long start) {
    candidates.forEach(each -> sources.put(each.id().port(), new RecordedSource(each, start)));
    this.now = start;
  }

  void take(RecordedValue value) {
    sources.get(value.port()).take(value);
    if (value.value() instanceof LogEntry entry) {
      log.add(entry);
    }
  }

  /** What time it is at the next look. */
  void at(long time) {
    now = time;
  }

  /** Entries are looked at once. */
  void looked() {
    log.clear();
  }

  @Override
  public List<Reading> readings(SourceName name) {
    return sources.values().stream().filter(each -> name.fits(each.candidate().id())).map(each -> each.reading(now))
        .toList();
  }

  @Override
  public List<Reading> readings(String typeName) {
    return sources.values().stream().filter(each -> each.candidate().typeName().equals(typeName))
        .map(each -> each.reading(now)).toList();
  }

  @Override
  public List<LogEntry> log() {
    return List.copyOf(log);
  }

  @Override
  public LinkState link() {
    return new LinkState.Connected("recording");
  }
}
