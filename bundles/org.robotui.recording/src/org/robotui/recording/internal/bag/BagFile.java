package org.robotui.recording.internal.bag;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import org.robotui.recording.RecordingException;
import org.robotui.recording.internal.io.OutputFile;

/** A file that grows, and whose beginning is written once more at the end. */
final class BagFile implements AutoCloseable {
  private final OutputFile file;
  private long position;

  private BagFile(OutputFile file) {
    this.file = file;
  }

  static BagFile create(Path path) throws RecordingException {
    return new BagFile(OutputFile.create(path));
  }

  Path path() {
    return file.path();
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

  private long put(ByteBuffer bytes, long at) throws RecordingException {
    try {
      return file.put(bytes, at);
    } catch (IOException e) {
      throw new RecordingException(file.path(), "cannot be written at byte " + at, e);
    }
  }

  @Override
  public void close() throws RecordingException {
    file.close();
  }
}
