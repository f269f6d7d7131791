package org.robotui.recorder.internal.file;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.robotui.api.record.RecordingPlan;
import org.robotui.recorder.internal.capture.Captured;
import org.robotui.recorder.internal.capture.StreamHead;
import org.robotui.recording.ChunkCompression;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordedMetadata;
import org.robotui.recording.RecordingException;
import org.robotui.recording.RecordingWriter;
import org.robotui.recording.WriterOptions;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The files of one recording: the next one is begun where the one before is long enough, and begins with what holds.
 * One thread writes, any thread looks.
 */
final class FileSeries {
  private static final Logger LOG = LoggerFactory.getLogger(FileSeries.class);
  private static final String NOTES = "robotui.recording";

  /** Makes writers. */
  @FunctionalInterface
  interface Maker {
    /** Begins a file. */
    RecordingWriter create(Path file, WriterOptions options) throws RecordingException;
  }

  /**
   * What each file has beside its messages.
   *
   * @param notes versions and the like
   * @param configurations their texts, without secrets, by their files
   */
  record Extras(Map<String, String> notes, Map<Path, String> configurations) {}

  private final RecordingPlan plan;
  private final Path base;
  private final Maker maker;
  private final Extras extras;
  private final HeldMessages held = new HeldMessages();
  private final List<Path> files = new CopyOnWriteArrayList<>();
  private final Map<StreamHead, RecordedChannel> channels = new IdentityHashMap<>();
  private Optional<RecordingWriter> writer = Optional.empty();
  private long begunAt;
  private volatile long closedBytes;
  private volatile long openBytes;
  private volatile long messages;

  /** Of a file, or of several that are named after it. */
  FileSeries(RecordingPlan plan, Path base, Maker maker, Extras extras) {
    this.plan = plan;
    this.base = base;
    this.maker = maker;
    this.extras = extras;
  }

  List<Path> files() {
    return files;
  }

  long bytes() {
    return closedBytes + openBytes;
  }

  long messages() {
    return messages;
  }

  /** Whether the first file was begun. */
  boolean isOpen() {
    return writer.isPresent();
  }

  static Path first(RecordingPlan plan, Path base) {
    return plan.splits() ? Disk.numbered(base, 1) : base;
  }

  /** Begins the next file. */
  void begin(long time) throws RecordingException {
    Path file = plan.splits() ? Disk.numbered(base, files.size() + 1) : base;
    if (Files.exists(file)) {
      throw new RecordingException(file, 0, "it is there already, and is not written over");
    }
    RecordingWriter next = maker.create(file, WriterOptions.defaults().withCompression(compression())
        .withChunkTime(Duration.ofMillis(500)));
    writer = Optional.of(next);
    files.add(file);
    begunAt = time;
    channels.clear();
    next.note(new RecordedMetadata(NOTES, extras.notes()));
    for (Map.Entry<Path, String> each : extras.configurations().entrySet()) {
      next.attach(each.getKey().getFileName().toString(), "application/yaml", time, 0,
          ByteBuffer.wrap(each.getValue().getBytes(StandardCharsets.UTF_8)));
    }
    for (Captured each : held.all()) {
      put(next, each.at(time));
    }
  }

  private ChunkCompression compression() {
    return switch (plan.packing()) {
      case NONE -> ChunkCompression.NONE;
      case LZ4 -> ChunkCompression.LZ4;
      case ZSTD -> ChunkCompression.ZSTD;
    };
  }

  /** Writes a message, to a new file where it is time for one. Whether a file was begun. */
  boolean write(Captured message) throws RecordingException {
    boolean next = writer.isEmpty() || isFull(message);
    if (next) {
      end();
      begin(message.logTime());
    }
    put(writer.get(), message);
    message.head().wrote(message.bytes().remaining());
    messages++;
    held.note(message);
    openBytes = writer.get().size();
    return next;
  }

  private boolean isFull(Captured message) {
    return plan.splitBytes().isPresent() && openBytes >= plan.splitBytes().getAsLong()
        || plan.splitTime().filter(limit -> message.logTime() - begunAt >= limit.toNanos()).isPresent();
  }

  private void put(RecordingWriter to, Captured message) throws RecordingException {
    RecordedChannel channel = channels.get(message.head());
    if (channel == null) {
      StreamHead head = message.head();
      channel = to.channel(head.topic(), head.encoding(), head.schema(), head.metadata());
      channels.put(head, channel);
    }
    to.write(channel, message.logTime(), message.publishTime(), message.sequence(),
        message.bytes().duplicate());
  }

  /** Ends the file that is open, if one is: what was lost stands in it. */
  void end() throws RecordingException {
    if (writer.isEmpty()) {
      return;
    }
    try (RecordingWriter closing = writer.get()) {
      writer = Optional.empty();
      closing.note(new RecordedMetadata("robotui.drops", drops()));
      closing.flush();
      openBytes = closing.size();
    } finally {
      closedBytes += fileSize(files.getLast());
      openBytes = 0;
    }
  }

  private Map<String, String> drops() {
    Map<String, Long> dropped = new LinkedHashMap<>();
    new ArrayList<>(channels.keySet()).forEach(head -> dropped.merge(head.topic(), head.dropped(), Long::sum));
    Map<String, String> notes = new LinkedHashMap<>();
    dropped.forEach((topic, count) -> {
      if (count != 0) {
        notes.put(topic, Long.toString(count));
      }
    });
    return notes;
  }

  private long fileSize(Path file) {
    try {
      return Files.size(file);
    } catch (IOException e) {
      LOG.debug("{} has gone", file, e);
      return openBytes;
    }
  }
}
