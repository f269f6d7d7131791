package org.robotui.recording.internal.io;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import org.robotui.recording.RecordingException;

/** A file that is written anew. */
public final class OutputFile implements AutoCloseable {
  private final Path path;
  private final FileChannel file;

  private OutputFile(Path path, FileChannel file) {
    this.path = path;
    this.file = file;
  }

  /** Opens it, empty. */
  public static OutputFile create(Path path) throws RecordingException {
    try {
      return new OutputFile(path, FileChannel.open(path, StandardOpenOption.CREATE, StandardOpenOption.WRITE,
          StandardOpenOption.TRUNCATE_EXISTING));
    } catch (IOException e) {
      throw new RecordingException(path, "cannot be written", e);
    }
  }

  public Path path() {
    return path;
  }

  /** Puts bytes at a place; gives where they end. */
  public long put(ByteBuffer bytes, long from) throws IOException {
    ByteBuffer left = bytes.duplicate();
    long at = from;
    while (left.hasRemaining()) {
      at += file.write(left, at);
    }
    return at;
  }

  /** Takes away what lies behind a place. */
  public void cut(long end) throws IOException {
    file.truncate(end);
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
