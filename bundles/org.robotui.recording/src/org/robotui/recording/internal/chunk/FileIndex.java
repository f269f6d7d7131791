package org.robotui.recording.internal.chunk;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.robotui.recording.RecordedAttachment;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordedMetadata;

/** What is known of a file without its messages. Filled by one thread while the file is opened. */
public final class FileIndex {

  private final Map<Integer, RecordedChannel> channels = new TreeMap<>();
  private final Map<Integer, Long> counts = new HashMap<>();
  private final List<ChunkRef> chunks = new ArrayList<>();
  private final List<RecordedAttachment> attachments = new ArrayList<>();
  private final List<RecordedMetadata> metadata = new ArrayList<>();

  public Map<Integer, RecordedChannel> channels() {
    return channels;
  }

  public Map<Integer, Long> counts() {
    return counts;
  }

  public List<ChunkRef> chunks() {
    return chunks;
  }

  public List<RecordedAttachment> attachments() {
    return attachments;
  }

  public List<RecordedMetadata> metadata() {
    return metadata;
  }

  /** Adds a part of a file that was read through. */
  public void scanned(long offset, long length, LoadedChunk chunk) {
    if (chunk.size() > 0) {
      chunk.channels().forEach(channel -> counts.merge(channel, 1L, Long::sum));
      chunks.add(ChunkRef.of(offset, length, chunk.logTime(0), chunk.logTime(chunk.size() - 1), chunk.size(),
          chunk.channels().distinct().toArray()));
    }
  }
}
