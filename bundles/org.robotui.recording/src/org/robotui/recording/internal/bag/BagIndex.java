package org.robotui.recording.internal.bag;

import java.util.HashSet;
import java.util.Set;
import org.robotui.recording.RecordingException;
import org.robotui.recording.internal.chunk.ChunkRef;
import org.robotui.recording.internal.chunk.FileIndex;
import org.robotui.recording.internal.io.ByteWindow;
import org.robotui.recording.internal.io.FileBytes;
import org.robotui.recording.internal.io.MalformedRecord;
import org.robotui.recording.internal.io.PackedFields;

/** Reads the index at the end of a bag: connections, and what is in which chunk. */
final class BagIndex {

  private static final long MOST_BYTES = 256 << 20;

  private final FileBytes file;
  private final FileIndex index = new FileIndex();
  private final BagConnections connections = new BagConnections(index.channels());
  private final Set<Long> places = new HashSet<>();

  BagIndex(FileBytes file) {
    this.file = file;
  }

  FileIndex index() {
    return index;
  }

  BagConnections connections() {
    return connections;
  }

  void read(BagFields bag, long first) throws RecordingException, MalformedRecord {
    long start = bag.size("index_pos");
    if (start < first || start > file.size()) {
      throw new MalformedRecord("the index should be at byte " + start);
    }
    if (file.size() - start > MOST_BYTES) {
      throw new MalformedRecord("the index has " + (file.size() - start) + " bytes");
    }
    ByteWindow window = new ByteWindow(file);
    long at = start;
    while (at < file.size()) {
      BagRecord record = BagRecord.at(at, file, window);
      if (record.end() > file.size()) {
        throw new MalformedRecord("the file ends in its index");
      }
      record(record, first, start);
      at = record.end();
    }
    connections.complete();
    if (index.channels().size() != bag.u32("conn_count") || index.chunks().size() != bag.u32("chunk_count")) {
      throw new MalformedRecord("the index has " + index.channels().size() + " connections and "
          + index.chunks().size() + " chunks, where the bag says " + bag.u32("conn_count") + " and "
          + bag.u32("chunk_count"));
    }
  }

  private void record(BagRecord record, long first, long end) throws RecordingException, MalformedRecord {
    int op = record.header().op();
    if (op == BagFields.CONNECTION || op == BagFields.CHUNK_INFO) {
      byte[] data = file.read(record.data(), (int) record.length());
      PackedFields fields = new PackedFields(data, 0, data.length);
      if (op == BagFields.CONNECTION) {
        connections.add(record.header(), fields);
      } else {
        chunk(record.header(), fields, first, end);
      }
    }
  }

  private void chunk(BagFields header, PackedFields data, long first, long end) throws MalformedRecord {
    long offset = header.size("chunk_pos");
    if (offset < first || offset >= end || !places.add(offset)) {
      throw new MalformedRecord("the index has a chunk at byte " + offset + ", twice or outside of the data");
    }
    int[] channels = new int[data.remaining() / (2 * Integer.BYTES)];
    long messages = 0;
    for (int i = 0; i < channels.length; i++) {
      channels[i] = (int) data.u32("a connection of a chunk");
      long count = data.u32("a count of messages");
      messages += count;
      index.counts().merge(channels[i], count, Long::sum);
    }
    long start = header.time("start_time");
    long last = header.time("end_time");
    if (last < start) {
      throw new MalformedRecord("the index has a chunk at byte " + offset + " that ends before it begins");
    }
    index.chunks().add(ChunkRef.of(offset, 0, start, last, messages, channels));
  }
}
