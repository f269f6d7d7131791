package org.robotui.lcm.log;

import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/** A file through a window that moves over it. */
final class LogWindow implements Closeable {

  private static final int SIZE = 1 << 18;

  private final FileChannel file;
  private final ByteBuffer window = ByteBuffer.allocate(SIZE).limit(0);
  private long start;

  private LogWindow(FileChannel file) {
    this.file = file;
  }

  static LogWindow open(Path path) throws IOException {
    return new LogWindow(FileChannel.open(path, StandardOpenOption.READ));
  }

  /** How long the file is now: it may be written meanwhile. */
  long size() throws IOException {
    return file.size();
  }

  /** A number at a place that is in the file. */
  int getInt(long at) throws IOException {
    return window.getInt(look(at, Integer.BYTES));
  }

  long getLong(long at) throws IOException {
    return window.getLong(look(at, Long.BYTES));
  }

  /** Bytes that are in the file; where it became shorter meanwhile, an error. */
  byte[] get(long at, int length) throws IOException {
    byte[] bytes = new byte[length];
    if (length <= SIZE / 2) {
      window.get(look(at, length), bytes);
    } else {
      readFully(ByteBuffer.wrap(bytes), at);
    }
    return bytes;
  }

  /** Where a word is next, from a place on; the end of the file if it is not. */
  long find(int word, long from) throws IOException {
    byte first = (byte) (word >>> 24);
    long end = size() - Integer.BYTES;
    for (long at = from; at <= end; at++) {
      int index = look(at, Integer.BYTES);
      if (window.get(index) == first && window.getInt(index) == word) {
        return at;
      }
    }
    return size();
  }

  private int look(long at, int length) throws IOException {
    if (at < start || at + length > start + window.limit()) {
      long left = size() - at;
      if (left < length) {
        throw new IOException("the file ends at byte " + size() + ", and byte " + (at + length) + " is asked for");
      }
      window.clear().limit((int) Math.min(SIZE, left));
      start = at;
      readFully(window, at);
      window.flip();
    }
    return (int) (at - start);
  }

  private void readFully(ByteBuffer target, long from) throws IOException {
    long at = from;
    while (target.hasRemaining()) {
      int count = file.read(target, at);
      if (count < 0) {
        window.clear().limit(0);
        throw new IOException("the file became shorter than " + (at + target.remaining()) + " bytes");
      }
      at += count;
    }
  }

  @Override
  public void close() throws IOException {
    file.close();
  }
}
