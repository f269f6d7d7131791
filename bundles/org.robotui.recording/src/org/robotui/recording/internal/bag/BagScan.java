package org.robotui.recording.internal.bag;

import java.util.Optional;
import org.robotui.recording.RecordingException;
import org.robotui.recording.ScanProgress;
import org.robotui.recording.internal.chunk.DamageList;
import org.robotui.recording.internal.chunk.FileIndex;
import org.robotui.recording.internal.io.ByteWindow;
import org.robotui.recording.internal.io.FileBytes;
import org.robotui.recording.internal.io.MalformedRecord;
import org.robotui.recording.internal.io.PackedFields;

/** Makes the index of a bag without a usable one by reading through it: those that are still written have none. */
final class BagScan {

  /** From the begin of a chunk to its kind: its other fields may come first. */
  private static final int FARTHEST_KIND = 64;

  private final FileBytes file;
  private final ByteWindow window;
  private final FileIndex index = new FileIndex();
  private final BagConnections connections = new BagConnections(index.channels());
  private final DamageList damages;
  private final BagSource source;
  private final RecordFinder finder;

  BagScan(FileBytes file, DamageList damages) {
    this.file = file;
    this.damages = damages;
    window = new ByteWindow(file);
    source = new BagSource(file, connections, damages);
    finder = new RecordFinder(file, window, BagFields.CHUNK, FARTHEST_KIND);
  }

  FileIndex index() {
    return index;
  }

  BagSource source() {
    return source;
  }

  void run(long first, ScanProgress progress) throws RecordingException {
    long at = first;
    while (at < file.size()) {
      Optional<BagRecord> record = record(at);
      if (record.isPresent()) {
        read(at, record.get());
        at = Math.min(record.get().end(), file.size());
      } else {
        long next = finder.next(at + 1, this::isChunk);
        damages.add(at, "there is no record, so that " + (next - at) + " bytes were left out");
        at = next;
      }
      progress.scanned(at, file.size());
    }
    connections.complete();
  }

  /** A record that begins there. Only a chunk may be cut off by the end of the file. */
  private Optional<BagRecord> record(long at) throws RecordingException {
    try {
      BagRecord record = BagRecord.at(at, file, window);
      return record.header().op() == BagFields.CHUNK || record.end() <= file.size() ? Optional.of(record)
          : Optional.empty();
    } catch (MalformedRecord e) {
      return Optional.empty();
    }
  }

  private void read(long at, BagRecord record) throws RecordingException {
    try {
      int op = record.header().op();
      if (op == BagFields.CHUNK) {
        index.scanned(at, 0, source.load(at, record));
      } else if (op == BagFields.CONNECTION) {
        byte[] data = file.read(record.data(), (int) record.length());
        connections.add(record.header(), new PackedFields(data, 0, data.length));
      }
    } catch (MalformedRecord e) {
      damages.add(at, "a record was left out: " + e.getMessage());
    }
  }

  private boolean isChunk(long start) throws RecordingException {
    Optional<BagRecord> record = record(start);
    try {
      return record.isPresent() && record.get().header().op() == BagFields.CHUNK
          && record.get().header().text("compression").isPresent() && record.get().header().text("size").isPresent();
    } catch (MalformedRecord e) {
      return false;
    }
  }
}
