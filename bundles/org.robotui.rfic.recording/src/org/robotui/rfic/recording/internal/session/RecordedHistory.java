package org.robotui.rfic.recording.internal.session;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.LongSupplier;
import org.robotui.api.port.Input;
import org.robotui.api.port.SourceId;
import org.robotui.api.replay.HistoryTaker;
import org.robotui.api.replay.TimeRange;
import org.robotui.api.replay.Timeline;
import org.robotui.data.ClockKind;
import org.robotui.data.DataType;
import org.robotui.message.data.Adapter;
import org.robotui.message.data.Adapters;
import org.robotui.message.data.FrameNames;
import org.robotui.message.payload.PayloadFormats;
import org.robotui.message.topic.TopicSettings;
import org.robotui.recording.RecordedMessage;
import org.robotui.recording.RecordingCursor;
import org.robotui.recording.RecordingInterval;
import org.robotui.recording.RecordingReader;
import org.robotui.rfic.recording.internal.time.SearchableHistory;
import org.robotui.rfic.recording.internal.time.SharedTimeline;

/**
 * All of a recording by the ports of its robot interface. Read by the same receptions and conversions as it is played.
 */
public final class RecordedHistory implements SearchableHistory {
  private static final int TOLD_EVERY = 4096;

  private final RecordingReader recording;
  private final TopicTable table;
  private final String file;
  private final TimeRange span;
  private final Timeline timeline;
  private final LongSupplier offset;
  private final Map<String, HistoryStream<?>> streams = new ConcurrentHashMap<>();
  private final List<Input.Candidate> candidates = new CopyOnWriteArrayList<>();

  RecordedHistory(RecordingReader recording, TopicTable table, String file, TimeRange span, Timeline timeline,
      LongSupplier offset) {
    this.recording = recording;
    this.table = table;
    this.file = file;
    this.span = span;
    this.timeline = timeline;
    this.offset = offset;
  }

  /**
   * All of a recording that is not played.
   *
   * @param recording is read; to be closed by who opened it
   * @param formats knows encodings
   * @param instance how the robot interface that would play it is called
   * @return reads it
   */
  public static RecordedHistory of(RecordingReader recording, PayloadFormats formats, String instance) {
    TimeRange span = recording.span().map(each -> new TimeRange(each.start(), each.end())).orElse(new TimeRange(0, 0));
    String name = recording.file().getFileName().toString();
    RecordedHistory made = new RecordedHistory(recording, new TopicTable(recording, formats), name, span,
        new SharedTimeline(), () -> 0);
    made.addAll(new FrameNames(name, ClockKind.SIMULATED), instance, TopicSettings.ALL);
    return made;
  }

  /** Adds all topics, also those that become no stream of their own while it is played. */
  void addAll(FrameNames names, String instance, TopicSettings settings) {
    Adapters adapters = new Adapters();
    table.topics().stream().filter(settings::offers).forEach(topic -> table.first(topic).ifPresent(channel -> {
      Adapter<?, ?> adapter = channel.format().definition().isPresent() ? adapters.of(channel.format().type())
          : adapters.ofFields(channel.format().type());
      String port = settings.portName(topic);
      add(HistoryStream.of(adapter, topic, port, names));
      candidates.add(new Input.Candidate(new SourceId(instance, port), DataType.of(adapter.data()).name()));
    }));
  }

  @Override
  public List<Input.Candidate> candidates() {
    return List.copyOf(candidates);
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
