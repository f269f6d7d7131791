package org.robotui.recording.internal.bag;

import org.robotui.recording.RecordingException;
import org.robotui.recording.internal.io.ByteWindow;
import org.robotui.recording.internal.io.FileBytes;

/**
 * Finds records of a kind behind a damage: by the field that says their kind, and so far before it that the header is
 * consistent.
 */
final class RecordFinder {

  private static final int OP_FIELD = 4;
  private static final int BEFORE_KIND = 7;

  private final FileBytes file;
  private final ByteWindow window;
  private final int kind;
  private final int farthest;

  /** Whether a record begins at a place. */
  interface Check {
    boolean test(long place) throws RecordingException;
  }

  /** From the begin of a record to its kind are at most some bytes: its other fields may come first. */
  RecordFinder(FileBytes file, ByteWindow window, int kind, int farthest) {
    this.file = file;
    this.window = window;
    this.kind = kind;
    this.farthest = farthest;
  }

  /** The next one from a place on; the size of the file if there is none. */
  long next(long from, Check check) throws RecordingException {
    long place = from;
    while (place < file.size()) {
      place = window.find((byte) kind, place);
      if (isKind(place)) {
        long earliest = Math.max(from, place - farthest);
        for (long start = place - 2L * Integer.BYTES - 3; start >= earliest; start--) {
          if (check.test(start)) {
            return start;
          }
        }
      }
      place++;
    }
    return file.size();
  }

  /** The bytes before it are {@code op=} after the length of such a field. */
  private boolean isKind(long place) throws RecordingException {
    return place < file.size() && place >= BEFORE_KIND && window.u32(place - BEFORE_KIND) == OP_FIELD
        && window.u8(place - 3) == 'o' && window.u8(place - 2) == 'p' && window.u8(place - 1) == '=';
  }
}
