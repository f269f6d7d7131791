package org.robotui.recording.internal.mcap;

import java.util.OptionalLong;
import org.robotui.recording.RecordingException;
import org.robotui.recording.ScanProgress;
import org.robotui.recording.internal.chunk.DamageList;
import org.robotui.recording.internal.chunk.FileIndex;
import org.robotui.recording.internal.chunk.LoadedChunk;
import org.robotui.recording.internal.io.ByteWindow;
import org.robotui.recording.internal.io.FileBytes;
import org.robotui.recording.internal.io.MalformedRecord;
import org.robotui.recording.internal.io.PackedFields;

/**
 * Makes the index of a file without a usable one by reading through it. Where a record cannot be one, it goes on at the
 * next chunk that is consistent in itself.
 */
final class McapScan {

  /** Messages that lie in no chunk are taken together up to so many bytes. */
  private static final int RUN = 1 << 20;

  /** Attachments begin with their names: no more of them is read. */
  private static final int ATTACHMENT_HEAD = 1 << 16;

  private final FileBytes file;
  private final ByteWindow window;
  private final FileIndex index = new FileIndex();
  private final McapDefinitions definitions = new McapDefinitions(index.channels());
  private final DamageList damages;
  private final McapSource source;
  private long at = McapFormat.magic().length;
  private long runStart = -1;
  private long suspect;

  McapScan(FileBytes file, DamageList damages) {
    this.file = file;
    this.damages = damages;
    window = new ByteWindow(file);
    source = new McapSource(file, definitions, damages);
  }

  FileIndex index() {
    return index;
  }

  McapSource source() {
    return source;
  }

  void run(ScanProgress progress) throws RecordingException {
    suspect = at;
    while (at < file.size() && !isEnd()) {
      OptionalLong length = length();
      if (length.isPresent()) {
        record(window.u8(at), length.getAsLong());
      } else {
        endRun();
        resume();
      }
      progress.scanned(at, file.size());
    }
    endRun();
    definitions.complete();
  }

  /** What follows the data is made of it. */
  private boolean isEnd() throws RecordingException {
    int code = window.u8(at);
    boolean whole = file.size() - at >= McapFormat.RECORD_HEAD;
    return whole && (code == McapFormat.DATA_END && window.i64(at + 1) == Integer.BYTES
        || code == McapFormat.FOOTER && window.i64(at + 1) == McapFormat.FOOTER_LENGTH - McapFormat.RECORD_HEAD);
  }

  /** The length of the record with its head; empty where it cannot be one. */
  private OptionalLong length() throws RecordingException {
    if (file.size() - at < McapFormat.RECORD_HEAD || window.u8(at) == 0) {
      return OptionalLong.empty();
    }
    long content = window.i64(at + 1);
    return content < 0 || content > file.size() - at - McapFormat.RECORD_HEAD ? OptionalLong.empty()
        : OptionalLong.of(content + McapFormat.RECORD_HEAD);
  }

  private void record(int code, long length) throws RecordingException {
    boolean run = code == McapFormat.MESSAGE || code == McapFormat.SCHEMA || code == McapFormat.CHANNEL;
    if (!run || at + length - runStart > RUN) {
      endRun();
    }
    if (run && runStart < 0) {
      runStart = at;
    }
    suspect = code == McapFormat.CHUNK ? at + length : at;
    if (code == McapFormat.CHUNK) {
      chunk(at, length);
    } else if (code == McapFormat.ATTACHMENT || code == McapFormat.METADATA) {
      note(code, length);
    }
    at += length;
  }

  private void endRun() throws RecordingException {
    if (runStart >= 0) {
      chunk(runStart, at - runStart);
      runStart = -1;
    }
  }

  private void chunk(long offset, long length) throws RecordingException {
    LoadedChunk chunk = source.load(offset, length);
    index.scanned(offset, length, chunk);
  }

  private void note(int code, long length) throws RecordingException {
    int most = code == McapFormat.ATTACHMENT ? ATTACHMENT_HEAD : McapFormat.MOST_RECORD;
    byte[] bytes = file.read(at, (int) Math.min(most, length));
    PackedFields fields = new PackedFields(bytes, McapFormat.RECORD_HEAD, bytes.length);
    try {
      if (code == McapFormat.ATTACHMENT) {
        index.attachments().add(McapAttachments.of(fields, at));
      } else {
        index.metadata().add(McapAttachments.metadata(fields));
      }
    } catch (MalformedRecord e) {
      damages.add(at, "a record was left out: " + e.getMessage());
    }
  }

  /**
   * A length may have been wrong before, so that the search begins behind the last record that was surely one. It
   * always ends behind where it began, or at the end of the file.
   */
  private void resume() throws RecordingException {
    long broken = at;
    long next = nextChunk(suspect == at ? at : suspect + 1);
    if (next < file.size()) {
      damages.add(Math.min(broken, next),
          "there is no record, so that " + Math.max(0, next - broken) + " bytes were left out up to the next chunk");
      at = next;
    } else {
      cutOff(broken);
      at = file.size();
    }
    suspect = at;
  }

  /** The last record of a file that was cut off, or whose writer was killed: a chunk may have messages all the same. */
  private void cutOff(long offset) throws RecordingException {
    if (file.size() - offset > McapFormat.RECORD_HEAD && window.u8(offset) == McapFormat.CHUNK
        && head(offset, false)) {
      chunk(offset, file.size() - offset);
    } else {
      damages.add(offset, "there is no whole record, so that the last " + (file.size() - offset)
          + " bytes were left out: the file was cut off, or its recorder was killed");
    }
  }

  private long nextChunk(long from) throws RecordingException {
    long place = window.find((byte) McapFormat.CHUNK, from);
    while (place < file.size() && !head(place, true)) {
      place = window.find((byte) McapFormat.CHUNK, place + 1);
    }
    return place;
  }

  /** Whether there is a chunk: its own length and those inside of it must agree. */
  private boolean head(long offset, boolean whole) throws RecordingException {
    int most = McapFormat.RECORD_HEAD + ChunkHead.SIZE + 8;
    if (file.size() - offset < most || window.i64(offset + 1) < 0) {
      return false;
    }
    long content = window.i64(offset + 1);
    long word = window.u32(offset + McapFormat.RECORD_HEAD + 28);
    if (word > 8 || whole && content > file.size() - offset - McapFormat.RECORD_HEAD) {
      return false;
    }
    byte[] bytes = file.read(offset + McapFormat.RECORD_HEAD, (int) (ChunkHead.SIZE + word));
    try {
      ChunkHead head = ChunkHead.of(new PackedFields(bytes, 0, bytes.length));
      return head.length() + ChunkHead.SIZE + word == content;
    } catch (MalformedRecord e) {
      return false;
    }
  }
}
