package org.robotui.recording.internal.mcap;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Path;
import java.util.zip.CRC32;
import org.robotui.recording.RecordingException;
import org.robotui.recording.internal.io.PackedBytes;

/**
 * A file that is written by whole records. Where one cannot be written, what was written of it is taken away again, so
 * that the file stays whole so far, and nothing more is written.
 */
final class McapFile implements AutoCloseable {

  private final Path path;
  private final RandomAccessFile file;
  private final CRC32 sum = new CRC32();
  private long position;
  private boolean failed;

  private McapFile(Path path, RandomAccessFile file) {
    this.path = path;
    this.file = file;
  }

  static McapFile create(Path path) throws RecordingException {
    try {
      RandomAccessFile file = new RandomAccessFile(path.toFile(), "rw");
      file.setLength(0);
      return new McapFile(path, file);
    } catch (IOException e) {
      throw new RecordingException(path, "cannot be written", e);
    }
  }

  void write(PackedBytes records) throws RecordingException {
    if (failed) {
      throw new RecordingException(path, position, "nothing more is written, as something could not be before");
    }
    try {
      file.write(records.array(), 0, records.size());
      sum.update(records.array(), 0, records.size());
      position += records.size();
    } catch (IOException e) {
      failed = true;
      takeBack(e);
      throw new RecordingException(path, "cannot be written at byte " + position, e);
    }
  }

  private void takeBack(IOException cause) {
    try {
      file.setLength(position);
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
  long sum() {
    return sum.getValue();
  }

  void restartSum() {
    sum.reset();
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
