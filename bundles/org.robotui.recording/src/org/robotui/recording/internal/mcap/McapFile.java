package org.robotui.recording.internal.mcap;

import java.io.IOException;
import java.nio.file.Path;
import org.robotui.recording.RecordingException;
import org.robotui.recording.internal.io.OutputFile;
import org.robotui.recording.internal.io.PackedBytes;

/**
 * A file that is written by whole records. Where one cannot be written, what was written of it is taken away again, so
 * that the file stays whole so far, and nothing more is written.
 */
final class McapFile implements AutoCloseable {

  private final OutputFile file;
  private int sum;
  private long position;
  private boolean failed;

  private McapFile(OutputFile file) {
    this.file = file;
  }

  static McapFile create(Path path) throws RecordingException {
    return new McapFile(OutputFile.create(path));
  }

  void write(PackedBytes records) throws RecordingException {
    write(SummedBytes.of(records.view()));
  }

  /** Writes whole records that lie in pieces. */
  void write(SummedBytes... pieces) throws RecordingException {
    if (failed) {
      throw new RecordingException(file.path(), position, "nothing more is written, as something could not be before");
    }
    try {
      long end = position;
      for (SummedBytes each : pieces) {
        end = file.put(each.bytes(), end);
      }
      for (SummedBytes each : pieces) {
        sum = JoinedSum.of(sum, each.sum(), each.bytes().remaining());
      }
      position = end;
    } catch (IOException e) {
      failed = true;
      takeBack(e);
      throw new RecordingException(file.path(), "cannot be written at byte " + position, e);
    }
  }

  private void takeBack(IOException cause) {
    try {
      file.cut(position);
    } catch (IOException e) {
      cause.addSuppressed(e);
    }
  }

  boolean isWritable() {
    return !failed;
  }

  long position() {
    return position;
  }

  /** The checksum of all that was written. */
  int sum() {
    return sum;
  }

  void restartSum() {
    sum = 0;
  }

  @Override
  public void close() throws RecordingException {
    file.close();
  }
}
