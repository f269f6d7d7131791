package org.robotui.rfic.recording.internal.time;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.robotui.api.config.AtomicFile;
import org.robotui.api.config.NamedFile;
import org.robotui.web.tree.JsonText;
import org.robotui.web.tree.TreeException;
import org.robotui.web.tree.Trees;

/** What users noted of recordings, as JSON. Nanoseconds are texts, as numbers of JSON are not that exact. */
final class NotesFile {
  private static final long MOST_BYTES = 16 << 20;
  private static final String RECORDING = "recording";
  private static final String OFFSET = "offset";
  private static final String BOOKMARKS = "bookmarks";
  private static final String TIME = "time";
  private static final String NOTE = "note";

  private NotesFile() {}

  /** Reads; throws where the file is there and cannot be read or understood. */
  static Map<String, FileNotes> read(Path file) throws IOException {
    if (!Files.exists(file)) {
      return Map.of();
    }
    try {
      Map<String, FileNotes> all = new LinkedHashMap<>();
      for (Object each : Trees.list(Trees.object(JsonText.read(NamedFile.text(file, MOST_BYTES))), "recordings")) {
        Map<String, Object> members = Trees.object(each);
        all.put(Trees.text(members, RECORDING), notes(members));
      }
      return all;
    } catch (TreeException | IllegalArgumentException e) {
      throw new IOException(file + " is not what was kept there: " + e.getMessage(), e);
    }
  }

  private static FileNotes notes(Map<String, Object> members) throws TreeException {
    Map<Long, String> bookmarks = new TreeMap<>();
    for (Object each : Trees.list(members, BOOKMARKS)) {
      Map<String, Object> bookmark = Trees.object(each);
      bookmarks.put(Long.valueOf(Trees.text(bookmark, TIME)), Trees.text(bookmark, NOTE));
    }
    return new FileNotes(Long.parseLong(Trees.text(members, OFFSET)), bookmarks);
  }

  /** Writes, for this user alone. */
  static void write(Path file, Map<String, FileNotes> all) throws IOException {
    List<Object> recordings = new ArrayList<>();
    all.forEach((identity, notes) -> {
      Map<String, Object> members = new LinkedHashMap<>();
      members.put(RECORDING, identity);
      members.put(OFFSET, Long.toString(notes.offset()));
      members.put(BOOKMARKS, notes.bookmarks().entrySet().stream()
          .map(e -> Map.of(TIME, Long.toString(e.getKey()), NOTE, e.getValue())).toList());
      recordings.add(members);
    });
    AtomicFile.writePrivate(file, JsonText.write(Map.of("recordings", recordings)));
  }
}
