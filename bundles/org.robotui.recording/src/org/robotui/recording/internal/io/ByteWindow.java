package org.robotui.recording.internal.io;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.robotui.recording.RecordingException;

/**
 * A part of a file that moves along with who reads through it, so that small pieces cost no call of the system each.
 */
public final class ByteWindow {

  private static final int LENGTH = 1 << 18;
  private static final int SHORT = 1 << 10;

  private final FileBytes file;
  private final byte[] bytes;
  private final ByteBuffer view;
  private long start;
  private int filled;

  private ByteWindow(FileBytes file, int length) {
    this.file = file;
    bytes = new byte[length];
    view = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
  }

  public ByteWindow(FileBytes file) {
    this(file, LENGTH);
  }

  /** One for who looks at a few bytes in one place. */
  public static ByteWindow small(FileBytes file) {
    return new ByteWindow(file, SHORT);
  }

  public int u8(long offset) throws RecordingException {
    return bytes[at(offset, 1)] & 0xff;
  }

  public long u32(long offset) throws RecordingException {
    return view.getInt(at(offset, Integer.BYTES)) & 0xffff_ffffL;
  }

  public long i64(long offset) throws RecordingException {
    return view.getLong(at(offset, Long.BYTES));
  }

  /** The first place from an offset on at which a byte stands; the size of the file if there is none. */
  public long find(byte wanted, long offset) throws RecordingException {
    long place = offset;
    while (place < file.size()) {
      int in = at(place, 1);
      while (in < filled && bytes[in] != wanted) {
        in++;
      }
      if (in < filled) {
        return start + in;
      }
      place = start + filled;
    }
    return file.size();
  }

  private int at(long offset, int length) throws RecordingException {
    if (offset < start || offset + length > start + filled) {
      if (offset < 0 || length > file.size() - offset) {
        throw new RecordingException(file.path(), offset, "the file ends where " + length + " bytes are wanted");
      }
      filled = 0;
      int most = (int) Math.min(bytes.length, file.size() - offset);
      file.read(offset, bytes, most);
      start = offset;
      filled = most;
    }
    return (int) (offset - start);
  }
}
