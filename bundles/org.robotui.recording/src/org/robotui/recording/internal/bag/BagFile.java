package org.robotui.recording.internal.bag;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import org.robotui.recording.RecordingException;

/** A file that grows, and whose beginning is written once more at the end. */
final class BagFile implements AutoCloseable {
  private final Path path;
  private final FileChannel file;
  private long position;

  private BagFile(Path path, FileChannel file) {
    this.path = path;
    this.file = file;
  }

  static BagFile create(Path path) throws RecordingException {
    try {
      return new BagFile(path, FileChannel.open(path, StandardOpenOption.CREATE, StandardOpenOption.WRITE,
          StandardOpenOption.TRUNCATE_EXISTING));
    } catch (IOException e) {
      throw new RecordingException(path, "cannot be written", e);
    }
  }

  Path path() {
    return path;
  }

  long position() {
    return position;
  }

  void append(ByteBuffer bytes) throws RecordingException {
    position = put(bytes, position);
  }

  /** Writes over bytes that are there. */
  void rewrite(ByteBuffer bytes, long at) throws RecordingException {
    put(bytes, at);
  }

  private long put(ByteBuffer bytes, long from) throws RecordingException {
    ByteBuffer left = bytes.duplicate();
    long at = from;
    try {
      while (left.hasRemaining()) {
        at += file.write(left, at);
      }
      return at;
    } catch (IOException e) {
      throw new RecordingException(path, "cannot be written at byte " + at, e);
    }
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
