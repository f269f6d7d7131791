package org.robotui.recording.internal.chunk;

import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.robotui.recording.RecordedAttachment;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordedMessage;
import org.robotui.recording.RecordedMetadata;
import org.robotui.recording.RecordingCursor;
import org.robotui.recording.RecordingDamage;
import org.robotui.recording.RecordingException;
import org.robotui.recording.RecordingInterval;
import org.robotui.recording.RecordingReader;

/** A recording of any format that consists of chunks. */
public final class ChunkedRecording implements RecordingReader {

  private final OpenedRecording opened;
  private final Map<Integer, RecordedChannel> channels;
  private final Map<Integer, Long> counts;
  private final List<RecordedAttachment> attachments;
  private final List<RecordedMetadata> metadata;
  private final TimeOrder order;
  private final ChunkCache cache;

  public ChunkedRecording(OpenedRecording opened) {
    this.opened = opened;
    FileIndex index = opened.index();
    channels = index.channels();
    counts = Map.copyOf(index.counts());
    attachments = List.copyOf(index.attachments());
    metadata = List.copyOf(index.metadata());
    order = new TimeOrder(index.chunks());
    cache = new ChunkCache(opened.source());
  }

  @Override
  public Path file() {
    return opened.path();
  }

  @Override
  public String format() {
    return opened.format();
  }

  @Override
  public boolean isIndexed() {
    return opened.indexed();
  }

  @Override
  public List<RecordedChannel> channels() {
    return List.copyOf(channels.values());
  }

  @Override
  public Optional<RecordingInterval> span() {
    return order.size() == 0 ? Optional.empty()
        : Optional.of(new RecordingInterval(order.get(0).start(), order.reach(order.size() - 1)));
  }

  @Override
  public Map<Integer, Long> messageCounts() {
    return counts;
  }

  @Override
  public List<RecordedAttachment> attachments() {
    return attachments;
  }

  @Override
  public ByteBuffer content(RecordedAttachment attachment) throws RecordingException {
    return opened.source().content(attachment);
  }

  @Override
  public List<RecordedMetadata> metadata() {
    return metadata;
  }

  @Override
  public List<RecordingDamage> damages() {
    return opened.damages().get();
  }

  @Override
  public RecordingCursor cursor(RecordingInterval interval, Set<Integer> wanted) {
    return new MergingCursor(order, cache, new ChannelFilter(channels, wanted), interval);
  }

  @Override
  public Optional<RecordedMessage> latestBefore(int channel, long time) throws RecordingException {
    Optional<RecordedMessage> newest = Optional.empty();
    long offset = -1;
    for (int place = order.until(time) - 1; place >= 0 && mayHaveNewer(place, newest); place--) {
      ChunkRef ref = order.get(place);
      Optional<RecordedMessage> found = ref.has(channel) ? lastIn(ref, channel, time) : Optional.empty();
      if (found.isPresent() && (newest.isEmpty() || isAfter(found.get(), ref.offset(), newest.get(), offset))) {
        newest = found;
        offset = ref.offset();
      }
    }
    return newest;
  }

  private boolean mayHaveNewer(int place, Optional<RecordedMessage> newest) {
    return newest.isEmpty() || order.reach(place) >= newest.get().logTime();
  }

  private Optional<RecordedMessage> lastIn(ChunkRef ref, int channel, long time) throws RecordingException {
    LoadedChunk chunk = cache.get(ref);
    int last = chunk.lastBefore(channel, time);
    return last < 0 ? Optional.empty() : Optional.of(chunk.message(last, channels.get(channel)));
  }

  /** Of messages of one time the last is that which lies last in the file, as cursors have it. */
  private static boolean isAfter(RecordedMessage one, long offset, RecordedMessage other, long otherOffset) {
    return one.logTime() > other.logTime() || one.logTime() == other.logTime() && offset > otherOffset;
  }

  @Override
  public void close() {
    opened.end().run();
  }
}
