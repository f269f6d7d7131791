package org.robotui.workbench.internal.timeline;

import java.time.Instant;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.robotui.api.replay.Bookmark;

/** Bookmarks as comma separated values (RFC 4180), for other programs. */
final class BookmarkTable {
  private static final double NANO = 1e-9;

  private BookmarkTable() {}

  /** In the order of time: seconds after the start of the recordings, the time in UTC, the note. */
  static String of(List<Bookmark> bookmarks, long start) {
    return bookmarks.stream().sorted(Comparator.comparingLong(Bookmark::time)).map(mark -> line(mark, start))
        .collect(Collectors.joining("", "seconds,time,note\n", ""));
  }

  private static String line(Bookmark mark, long start) {
    return String.format(Locale.ROOT, "%.6f,%s,\"%s\"\n", (mark.time() - start) * NANO,
        Instant.EPOCH.plusNanos(mark.time()), mark.note().replace("\"", "\"\""));
  }
}
