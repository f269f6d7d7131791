package org.robotui.recording.internal.sqlite;

import java.nio.ByteBuffer;
import org.robotui.recording.RecordingException;
import org.robotui.recording.internal.io.MalformedRecord;

/**
 * Where a row lies.
 *
 * @param page the bytes of its page
 * @param id its number
 * @param length of its bytes
 * @param from where they begin in the page
 * @param local how many of them lie there
 * @param overflow the page where they go on
 */
public record SqliteRow(byte[] page, long id, long length, int from, int local, long overflow) {

  /** What its page has of it; columns that go on elsewhere are known by their place and length. */
  public SqliteValues values() throws MalformedRecord {
    return new SqliteValues(page, from, local, length);
  }

  /** All of it, where that is not too much. */
  public SqliteValues values(SqlitePages pages, int most) throws RecordingException, MalformedRecord {
    if (length > Math.min(most, pages.mostBytes())) {
      throw new MalformedRecord("a row of " + length + " bytes is too long");
    }
    byte[] all = new byte[(int) length];
    copy(pages, 0, all, 0, all.length);
    return new SqliteValues(all, 0, all.length, length);
  }

  /** Copies some bytes of it; who asks has bounded the length. */
  public void copy(SqlitePages pages, long start, byte[] into, int at, int count)
      throws RecordingException, MalformedRecord {
    long place = start;
    int done = 0;
    if (place < local) {
      done = (int) Math.min(count, local - place);
      System.arraycopy(page, from + (int) place, into, at, done);
      place += done;
    }
    long next = overflow;
    long begin = local;
    int room = pages.usable() - Integer.BYTES;
    byte[] head = new byte[Integer.BYTES];
    while (done < count) {
      pages.read(next, 0, head, 0, head.length);
      if (place < begin + room) {
        int part = (int) Math.min(count - done, begin + room - place);
        pages.read(next, Integer.BYTES + (int) (place - begin), into, at + done, part);
        done += part;
        place += part;
      }
      begin += room;
      next = ByteBuffer.wrap(head).getInt() & 0xffff_ffffL;
    }
  }
}
