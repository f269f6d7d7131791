package org.robotui.recording.internal.mcap;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.OptionalLong;
import java.util.Set;
import org.robotui.recording.RecordingException;
import org.robotui.recording.internal.chunk.ChunkRef;
import org.robotui.recording.internal.chunk.FileIndex;
import org.robotui.recording.internal.io.FileBytes;
import org.robotui.recording.internal.io.MalformedRecord;
import org.robotui.recording.internal.io.PackedFields;

/**
 * Reads the summary at the end of a file, and judges whether it is one that can be relied on: whether it has all
 * channels, and whether its chunks have all messages that it counts.
 */
final class McapSummary {

  private static final long MOST_BYTES = 256 << 20;
  private static final int INDEX_HEAD = McapFormat.RECORD_HEAD + 6;
  private static final int INDEX_ENTRY = 16;

  private final FileBytes file;
  private final FileIndex index = new FileIndex();
  private final McapDefinitions definitions = new McapDefinitions(index.channels());
  private final Set<Integer> used = new HashSet<>();
  private final List<long[]> notes = new ArrayList<>();
  private long start;
  private long counted;
  private long messages = -1;
  private long chunkCount = -1;

  McapSummary(FileBytes file) {
    this.file = file;
  }

  FileIndex index() {
    return index;
  }

  McapDefinitions definitions() {
    return definitions;
  }

  /** Where the summary begins; empty where the file says that there is none. */
  OptionalLong start() throws RecordingException, MalformedRecord {
    long footer = file.size() - McapFormat.magic().length - McapFormat.FOOTER_LENGTH;
    if (footer < McapFormat.magic().length) {
      throw new MalformedRecord("the file ends before its end is marked");
    }
    byte[] bytes = file.read(footer, McapFormat.FOOTER_LENGTH + McapFormat.magic().length);
    PackedFields fields = new PackedFields(bytes, 0, bytes.length);
    if (fields.u8("the footer") != McapFormat.FOOTER || fields.size("the footer") != McapFormat.FOOTER_LENGTH
        - McapFormat.RECORD_HEAD || !endsWithMagic(bytes)) {
      throw new MalformedRecord("the file ends before its end is marked");
    }
    long summary = fields.size("the place of the summary");
    if (summary > footer) {
      throw new MalformedRecord("the summary should be at byte " + summary + ", behind the footer");
    }
    return summary == 0 ? OptionalLong.empty() : OptionalLong.of(summary);
  }

  private static boolean endsWithMagic(byte[] bytes) {
    byte[] magic = McapFormat.magic();
    return Arrays.equals(bytes, bytes.length - magic.length, bytes.length, magic, 0, magic.length);
  }

  /** Returns whether all that is needed was there. */
  boolean read(long summary) throws RecordingException, MalformedRecord {
    start = summary;
    long end = file.size() - McapFormat.magic().length;
    if (end - start > MOST_BYTES) {
      throw new MalformedRecord("the summary has " + (end - start) + " bytes");
    }
    byte[] bytes = file.read(start, (int) (end - start));
    PackedFields last = new PackedFields(bytes, bytes.length - Integer.BYTES, bytes.length);
    int sum = (int) last.u32("the checksum of the summary");
    if (sum != 0 && sum != McapSource.sum(bytes, 0, bytes.length - Integer.BYTES)) {
      throw new MalformedRecord("the checksum of the summary is wrong");
    }
    // channels name schemas, which may stand behind them
    records(bytes, McapFormat.SCHEMA);
    records(bytes, McapFormat.CHANNEL);
    records(bytes, 0);
    definitions.complete();
    checkPlaces();
    readNotes();
    return chunkCount == index.chunks().size() && messages == counted
        && index.channels().keySet().containsAll(used);
  }

  private void records(byte[] bytes, int wanted) throws MalformedRecord {
    PackedFields fields = new PackedFields(bytes, 0, bytes.length);
    while (fields.hasMore()) {
      int code = fields.u8("the code of a record");
      long size = fields.size("the length of a record");
      int from = fields.skip(size, "a record of the summary");
      PackedFields content = new PackedFields(bytes, from, from + (int) size);
      if (code == wanted && code == McapFormat.SCHEMA) {
        definitions.schema(content);
      } else if (code == wanted) {
        definitions.channel(content);
      } else if (wanted == 0) {
        indexed(code, content);
      }
    }
  }

  private void indexed(int code, PackedFields fields) throws MalformedRecord {
    switch (code) {
      case McapFormat.CHUNK_INDEX -> chunk(fields);
      case McapFormat.STATISTICS -> statistics(fields);
      case McapFormat.ATTACHMENT_INDEX -> index.attachments().add(McapAttachments.ofIndex(fields));
      case McapFormat.METADATA_INDEX -> notes
          .add(new long[]{fields.size("the place of metadata"), fields.size("the length of metadata")});
      default -> {
        // groups of the summary, and what later versions have
      }
    }
  }

  private void chunk(PackedFields fields) throws MalformedRecord {
    long first = fields.i64("the start of a chunk");
    long last = fields.i64("the end of a chunk");
    long offset = fields.size("the place of a chunk");
    long length = fields.size("the length of a chunk");
    PackedFields offsets = fields.part("the message indexes of a chunk");
    int[] channels = new int[offsets.remaining() / (Short.BYTES + Long.BYTES)];
    for (int i = 0; i < channels.length; i++) {
      channels[i] = offsets.u16("a channel of a chunk");
      offsets.size("the place of a message index");
      used.add(channels[i]);
    }
    long indexes = fields.size("the length of message indexes");
    long count = Math.max(0, (indexes - (long) channels.length * INDEX_HEAD) / INDEX_ENTRY);
    counted += count;
    index.chunks().add(ChunkRef.of(offset, length, first, last, count, channels));
  }

  private void statistics(PackedFields fields) throws MalformedRecord {
    messages = fields.size("the count of messages");
    fields.u16("the count of schemas");
    fields.u32("the count of channels");
    fields.u32("the count of attachments");
    fields.u32("the count of metadata");
    chunkCount = fields.u32("the count of chunks");
    fields.i64("the time of the first message");
    fields.i64("the time of the last message");
    PackedFields counts = fields.part("the counts of messages");
    while (counts.hasMore()) {
      int channel = counts.u16("a channel");
      used.add(channel);
      index.counts().put(channel, counts.size("the count of messages of channel " + channel));
    }
  }

  /** Nothing lies twice or outside of the data: who reads all chunks comes to an end. */
  private void checkPlaces() throws MalformedRecord {
    List<ChunkRef> chunks = new ArrayList<>(index.chunks());
    chunks.sort(Comparator.comparingLong(ChunkRef::offset));
    long behind = McapFormat.magic().length;
    for (ChunkRef chunk : chunks) {
      if (chunk.offset() < behind || chunk.length() < McapFormat.RECORD_HEAD
          || chunk.length() > start - chunk.offset()) {
        throw new MalformedRecord("the index has a chunk at byte " + chunk.offset() + " with " + chunk.length()
            + " bytes, which is in another one or outside of the data");
      }
      if (chunk.end() < chunk.start()) {
        throw new MalformedRecord("the index has a chunk at byte " + chunk.offset() + " that ends before it begins");
      }
      behind = chunk.offset() + chunk.length();
    }
  }

  private void readNotes() throws RecordingException, MalformedRecord {
    for (long[] note : notes) {
      if (note[0] > start || note[1] < McapFormat.RECORD_HEAD || note[1] > McapFormat.MOST_RECORD
          || note[1] > start - note[0]) {
        throw new MalformedRecord("the index has metadata of " + note[1] + " bytes at byte " + note[0]);
      }
      byte[] bytes = file.read(note[0], (int) note[1]);
      index.metadata().add(McapAttachments.metadata(new PackedFields(bytes, McapFormat.RECORD_HEAD, bytes.length)));
    }
  }
}
