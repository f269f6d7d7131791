package org.robotui.rfic.recording.internal.session;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.LongSupplier;
import org.robotui.api.replay.HistoryTaker;
import org.robotui.api.replay.StreamHistory;
import org.robotui.api.replay.TimeRange;
import org.robotui.api.replay.Timeline;
import org.robotui.recording.RecordedMessage;
import org.robotui.recording.RecordingCursor;
import org.robotui.recording.RecordingInterval;
import org.robotui.recording.RecordingReader;

/**
 * All of a recording by the ports of its robot interface. Read by the same receptions and conversions as it is played.
 */
final class RecordedHistory implements StreamHistory {
  private static final int TOLD_EVERY = 4096;

  private final RecordingReader recording;
  private final TopicTable table;
  private final String file;
  private final TimeRange span;
  private final Timeline timeline;
  private final LongSupplier offset;
  private final Map<String, HistoryStream<?>> streams = new ConcurrentHashMap<>();

  RecordedHistory(RecordingReader recording, TopicTable table, String file, TimeRange span, Timeline timeline,
      LongSupplier offset) {
    this.recording = recording;
    this.table = table;
    this.file = file;
    this.span = span;
    this.timeline = timeline;
    this.offset = offset;
  }

  void add(HistoryStream<?> stream) {
    streams.put(stream.port(), stream);
  }

  @Override
  public Timeline timeline() {
    return timeline;
  }

  @Override
  public TimeRange span() {
    return span;
  }

  @Override
  public long offset() {
    return offset.getAsLong();
  }

  @Override
  public long count(String port) {
    return Optional.ofNullable(streams.get(port)).map(stream -> stream.count(table)).orElse(0L);
  }

  @Override
  public void read(Set<String> ports, TimeRange range, HistoryTaker taker) throws IOException, InterruptedException {
    Map<Integer, List<HistoryStream.Run<?>>> byChannel = runs(ports, taker);
    if (byChannel.isEmpty()
        || read(recording.cursor(new RecordingInterval(range.start(), range.end()), byChannel.keySet()), byChannel,
            taker)) {
      taker.reached(range.end());
    }
  }

  /** False where no more was wanted. */
  private static boolean read(RecordingCursor cursor, Map<Integer, List<HistoryStream.Run<?>>> byChannel,
      HistoryTaker taker) throws IOException, InterruptedException {
    int count = 0;
    for (Optional<RecordedMessage> next = cursor.next(); next.isPresent(); next = cursor.next()) {
      RecordedMessage message = next.get();
      if (count++ % TOLD_EVERY == 0 && !taker.reached(message.logTime())) {
        return false;
      }
      if (Thread.interrupted()) {
        throw new InterruptedException();
      }
      byChannel.get(message.channel().id()).forEach(run -> run.give(message));
    }
    return true;
  }

  private Map<Integer, List<HistoryStream.Run<?>>> runs(Set<String> ports, HistoryTaker taker) {
    Map<Integer, List<HistoryStream.Run<?>>> byChannel = new HashMap<>();
    for (String port : ports) {
      HistoryStream<?> stream = streams.get(port);
      if (stream != null) {
        HistoryStream.Run<?> run = stream.run(table, file, taker);
        if (!run.reception().failure().isEmpty()) {
          taker.unreadable(port, run.reception().failure());
        }
        run.reception().channels().forEach(
            each -> byChannel.computeIfAbsent(each.channel().id(), id -> new ArrayList<>()).add(run));
      }
    }
    return byChannel;
  }
}
