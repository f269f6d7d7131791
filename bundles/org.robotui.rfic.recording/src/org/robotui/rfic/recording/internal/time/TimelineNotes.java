package org.robotui.rfic.recording.internal.time;

import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.robotui.api.config.SetAside;
import org.robotui.api.config.WriteFailure;
import org.robotui.api.replay.Bookmark;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * What users noted of recordings, and how they moved them: kept for each recording, in its own time, so that it is
 * found again wherever the file lies. Safe for all threads.
 */
final class TimelineNotes {
  private static final Logger LOG = LoggerFactory.getLogger(TimelineNotes.class);
  private static final String FILE = "timeline.json";
  private static final int MOST_FILES = 1000;
  private static final int MOST_BOOKMARKS = 10_000;

  private final Map<Long, Bookmark> shown = new TreeMap<>();
  private final Map<String, FileNotes> files = new LinkedHashMap<>();
  private final Object writing = new Object();
  private volatile Optional<Path> place = Optional.empty();
  private boolean changed;

  /** Reads what was kept, at the first call. */
  synchronized void read(Path folder) {
    if (place.isPresent()) {
      return;
    }
    Path file = folder.resolve(FILE);
    place = Optional.of(file);
    try {
      files.putAll(NotesFile.read(file));
    } catch (IOException e) {
      LOG.warn("Bookmarks and offsets of recordings begin anew: {}. {}", e.getMessage(), SetAside.copy(file));
    }
  }

  /** Writes what has changed. Blocks for the file, and nobody else meanwhile who does not write it. */
  void save() {
    synchronized (writing) {
      takeChanged().ifPresent(this::write);
    }
  }

  private synchronized Optional<Map<String, FileNotes>> takeChanged() {
    boolean due = changed && place.isPresent();
    changed &= !due;
    return due ? Optional.of(new LinkedHashMap<>(files)) : Optional.empty();
  }

  private void write(Map<String, FileNotes> now) {
    Path file = place.orElseThrow();
    try {
      NotesFile.write(file, now);
    } catch (IOException e) {
      LOG.warn("Bookmarks and offsets of recordings cannot be kept: {} cannot be written: {}", file,
          WriteFailure.reason(e));
    }
  }

  synchronized long offset(String identity) {
    return of(identity).offset();
  }

  /** Shows the bookmarks of a recording. */
  synchronized void load(Seat seat) {
    of(seat.track().identity()).bookmarks()
        .forEach((time, note) -> shown.put(seat.toTimeline(time), new Bookmark(seat.toTimeline(time), note)));
  }

  synchronized List<Bookmark> bookmarks() {
    return List.copyOf(shown.values());
  }

  /** Shows no bookmarks any more; they are kept all the same. */
  synchronized void clear() {
    shown.clear();
  }

  synchronized void shifted(Seat seat) {
    FileNotes before = of(seat.track().identity());
    put(seat.track().identity(), new FileNotes(seat.kept(), before.bookmarks()));
  }

  /** A bookmark belongs to the first recording that has its time. */
  synchronized void mark(Bookmark bookmark, List<Seat> seats) {
    unmark(bookmark.time(), seats);
    if (shown.size() < MOST_BOOKMARKS) {
      shown.put(bookmark.time(), bookmark);
      Seat owner =
          seats.stream().filter(seat -> seat.span().nearest(bookmark.time()) == bookmark.time()).findFirst()
              .orElse(seats.getFirst());
      String identity = owner.track().identity();
      put(identity, of(identity).with(owner.toFile(bookmark.time()), bookmark.note()));
    }
  }

  synchronized void unmark(long time, List<Seat> seats) {
    shown.remove(time);
    for (Seat seat : seats) {
      String identity = seat.track().identity();
      FileNotes before = of(identity);
      if (before.bookmarks().containsKey(seat.toFile(time))) {
        put(identity, before.without(seat.toFile(time)));
      }
    }
  }

  private FileNotes of(String identity) {
    return files.getOrDefault(identity, FileNotes.NONE);
  }

  /** What was changed last stands last: of too many files the first go. */
  private void put(String identity, FileNotes notes) {
    changed = true;
    files.remove(identity);
    if (!notes.isEmpty()) {
      files.put(identity, notes);
    }
    if (files.size() > MOST_FILES) {
      files.remove(files.keySet().iterator().next());
    }
  }
}
