package org.robotui.rfic.recording.internal.time;

import java.util.Collections;
import java.util.Map;
import java.util.TreeMap;

/**
 * What a user noted of one recording.
 *
 * @param offset what is added to its times beside what is configured, nanoseconds
 * @param bookmarks words by the time in the file
 */
record FileNotes(long offset, Map<Long, String> bookmarks) {
  static final FileNotes NONE = new FileNotes(0, Map.of());

  FileNotes {
    bookmarks = Collections.unmodifiableMap(new TreeMap<>(bookmarks));
  }

  boolean isEmpty() {
    return offset == 0 && bookmarks.isEmpty();
  }

  FileNotes with(long time, String note) {
    Map<Long, String> more = new TreeMap<>(bookmarks);
    more.put(time, note);
    return new FileNotes(offset, more);
  }

  FileNotes without(long time) {
    Map<Long, String> fewer = new TreeMap<>(bookmarks);
    fewer.remove(time);
    return new FileNotes(offset, fewer);
  }
}
