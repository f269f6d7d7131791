package org.robotui.recording.internal.io;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Path;
import org.robotui.recording.RecordingException;

/**
 * The bytes of a file, read by their places. It is as long as it was when it was opened. Any thread may use it; unlike
 * a {@link java.nio.channels.FileChannel}, a thread that is interrupted does not close it for all others.
 */
public final class FileBytes implements AutoCloseable {

  /** For more at once the system's memory is asked for anew each time, and every page of it is touched. */
  private static final int PIECE = 1 << 16;

  private final Path path;
  private final RandomAccessFile file;
  private final long size;

  private FileBytes(Path path, RandomAccessFile file, long size) {
    this.path = path;
    this.file = file;
    this.size = size;
  }

  public static FileBytes open(Path path) throws RecordingException {
    return open(path, path);
  }

  /** Opens what another file has become, and is told of by the name of that. */
  public static FileBytes open(Path place, Path path) throws RecordingException {
    try {
      RandomAccessFile file = new RandomAccessFile(place.toFile(), "r");
      return new FileBytes(path, file, file.length());
    } catch (IOException e) {
      throw new RecordingException(path, "cannot be opened", e);
    }
  }

  public Path path() {
    return path;
  }

  public long size() {
    return size;
  }

  /** What lies there; who asks has bounded the length. */
  public byte[] read(long offset, int length) throws RecordingException {
    byte[] bytes = new byte[length];
    read(offset, bytes, length);
    return bytes;
  }

  public void read(long offset, byte[] into, int length) throws RecordingException {
    if (offset < 0 || length > size - offset) {
      throw new RecordingException(path, offset, length + " bytes are wanted of a file of " + size);
    }
    synchronized (file) {
      try {
        file.seek(offset);
        for (int done = 0; done < length; done += PIECE) {
          file.readFully(into, done, Math.min(PIECE, length - done));
        }
      } catch (IOException e) {
        throw new RecordingException(path, "cannot be read at byte " + offset, e);
      }
    }
  }

  @Override
  public void close() {
    synchronized (file) {
      try {
        file.close();
      } catch (IOException e) {
        // it was only read
        return;
      }
    }
  }
}
