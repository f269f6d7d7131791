package org.robotui.recording.internal.sqlite;

import java.nio.ByteBuffer;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Optional;
import org.robotui.recording.RecordingException;
import org.robotui.recording.internal.chunk.DamageList;
import org.robotui.recording.internal.io.FileBytes;
import org.robotui.recording.internal.io.MalformedRecord;

/**
 * The pages of an SQLite database that nobody writes to, with those that its recorder had not moved into it yet. For
 * one thread.
 *
 * <p>Source: "Database File Format" in SQLite's documentation.
 */
public final class SqlitePages {

  private static final byte[] MAGIC = "SQLite format 3\0".getBytes(StandardCharsets.US_ASCII);
  private static final int HEAD = 100;
  private static final int WINDOW = 1 << 18;

  private final FileBytes file;
  private final Optional<SqliteLog> log;
  private final int size;
  private final int usable;
  private final long count;
  private final Charset charset;
  private final byte[] window;
  private long windowStart;
  private int windowLength;

  private SqlitePages(FileBytes file, Optional<SqliteLog> log, ByteBuffer head) throws MalformedRecord {
    this.file = file;
    this.log = log;
    this.size = pageSize(head);
    this.usable = size - (head.get(20) & 0xff);
    this.count = Math.min(Integer.MAX_VALUE, Math.max(file.size() / size, log.map(SqliteLog::pages).orElse(0L)));
    this.charset = switch (head.getInt(56)) {
      case 2 -> StandardCharsets.UTF_16LE;
      case 3 -> StandardCharsets.UTF_16BE;
      default -> StandardCharsets.UTF_8;
    };
    this.window = new byte[Math.max(WINDOW, size)];
    if (usable < 480) {
      throw new MalformedRecord("pages of " + usable + " bytes are too small");
    }
  }

  /** Whether a file is a database, by its first bytes. */
  public static boolean isOne(FileBytes file) throws RecordingException {
    return file.size() >= HEAD && Arrays.equals(file.read(0, MAGIC.length), MAGIC);
  }

  /**
   * @param log the file with {@code -wal} in its name, where there is one
   */
  public static SqlitePages open(FileBytes file, Optional<FileBytes> log, DamageList damages)
      throws RecordingException, MalformedRecord {
    ByteBuffer head = ByteBuffer.wrap(file.read(0, HEAD));
    int size = pageSize(head);
    Optional<SqliteLog> read =
        log.isPresent() ? SqliteLog.read(log.get(), size, damages) : Optional.empty();
    SqlitePages pages = new SqlitePages(file, read, head);
    long said = head.getInt(28) & 0xffff_ffffL;
    if (head.getInt(24) == head.getInt(92) && said > pages.count) {
      damages.add(file.size(), "the file ends early: it has " + pages.count + " pages where " + said + " should be");
    }
    return pages;
  }

  private static int pageSize(ByteBuffer head) throws MalformedRecord {
    int said = head.getShort(16) & 0xffff;
    int size = said == 1 ? 1 << 16 : said;
    if (size < 512 || Integer.bitCount(size) != 1) {
      throw new MalformedRecord("a database has no pages of " + size + " bytes");
    }
    return size;
  }

  long count() {
    return count;
  }

  int usable() {
    return usable;
  }

  Charset charset() {
    return charset;
  }

  /** No row is longer than this. */
  public long mostBytes() {
    return count * size;
  }

  /** The byte at which a page begins, to tell of it. */
  long place(long page) {
    return Math.max(0, page - 1) * size;
  }

  byte[] page(long page) throws RecordingException, MalformedRecord {
    byte[] bytes = new byte[size];
    read(page, 0, bytes, 0, size);
    return bytes;
  }

  void read(long page, int from, byte[] into, int at, int length) throws RecordingException, MalformedRecord {
    if (page < 1 || page > count) {
      throw new MalformedRecord("there is no page " + page);
    }
    Optional<byte[]> newer = log.isPresent() ? log.get().page(page) : Optional.empty();
    if (newer.isPresent()) {
      System.arraycopy(newer.get(), from, into, at, length);
    } else {
      System.arraycopy(window, windowed(place(page)) + from, into, at, length);
    }
  }

  /** Rows of many pages have them one after another. */
  private int windowed(long place) throws RecordingException, MalformedRecord {
    if (place + size > file.size()) {
      throw new MalformedRecord("the file ends in the page at byte " + place);
    }
    if (place < windowStart || place + size > windowStart + windowLength) {
      windowLength = 0;
      int most = (int) Math.min(window.length, file.size() - place);
      file.read(place, window, most);
      windowStart = place;
      windowLength = most;
    }
    return (int) (place - windowStart);
  }
}
