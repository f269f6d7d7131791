package org.robotui.recording.internal.mcap;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import org.robotui.recording.RecordingException;
import org.robotui.recording.internal.io.PackedBytes;

/**
 * A file that is written by whole records. Where one cannot be written, what was written of it is taken away again, so
 * that the file stays whole so far, and nothing more is written.
 */
final class McapFile implements AutoCloseable {

  private final Path path;
  private final FileChannel file;
  private int sum;
  private long position;
  private boolean failed;

  private McapFile(Path path, FileChannel file) {
    this.path = path;
    this.file = file;
  }

  static McapFile create(Path path) throws RecordingException {
    try {
      return new McapFile(path, FileChannel.open(path, StandardOpenOption.CREATE, StandardOpenOption.WRITE,
          StandardOpenOption.TRUNCATE_EXISTING));
    } catch (IOException e) {
      throw new RecordingException(path, "cannot be written", e);
    }
  }

  void write(PackedBytes records) throws RecordingException {
    write(SummedBytes.of(records.view()));
  }

  /** Writes whole records that lie in pieces. */
  void write(SummedBytes... pieces) throws RecordingException {
    if (failed) {
      throw new RecordingException(path, position, "nothing more is written, as something could not be before");
    }
    try {
      long written = 0;
      for (SummedBytes each : pieces) {
        written += each.bytes().remaining();
        write(each.bytes().duplicate());
      }
      for (SummedBytes each : pieces) {
        sum = JoinedSum.of(sum, each.sum(), each.bytes().remaining());
      }
      position += written;
    } catch (IOException e) {
      failed = true;
      takeBack(e);
      throw new RecordingException(path, "cannot be written at byte " + position, e);
    }
  }

  private void write(ByteBuffer bytes) throws IOException {
    while (bytes.hasRemaining()) {
      file.write(bytes);
    }
  }

  private void takeBack(IOException cause) {
    try {
      file.truncate(position);
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
    try {
      file.close();
    } catch (IOException e) {
      throw new RecordingException(path, "cannot be closed", e);
    }
  }
}
