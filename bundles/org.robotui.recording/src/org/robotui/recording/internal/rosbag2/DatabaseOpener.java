package org.robotui.recording.internal.rosbag2;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordedSchema;
import org.robotui.recording.RecordingException;
import org.robotui.recording.ScanProgress;
import org.robotui.recording.internal.chunk.DamageList;
import org.robotui.recording.internal.chunk.FileIndex;
import org.robotui.recording.internal.chunk.OpenedRecording;
import org.robotui.recording.internal.io.FileBytes;
import org.robotui.recording.internal.io.MalformedRecord;
import org.robotui.recording.internal.sqlite.SqlitePages;
import org.robotui.recording.internal.sqlite.SqliteTable;
import org.robotui.recording.internal.sqlite.SqliteTables;
import org.robotui.recording.internal.sqlite.SqliteValues;

/**
 * Opens databases of rosbag2 by reading through their table of messages: the index that they have is of times alone,
 * and says nothing of channels.
 */
public final class DatabaseOpener {

  private static final String FORMAT = "rosbag2 sqlite3";
  private static final int MOST_DEFINITION = 16 << 20;

  private final FileBytes file;
  private final DamageList damages;
  private final SqliteTables tables;
  private final Map<String, RecordedSchema> schemas = new HashMap<>();
  private final Map<Long, Integer> numbers = new HashMap<>();
  private final FileIndex index = new FileIndex();

  private DatabaseOpener(FileBytes file, SqlitePages pages, DamageList damages) throws RecordingException {
    this.file = file;
    this.damages = damages;
    this.tables = new SqliteTables(pages, damages);
  }

  /** Opens a database, with the log that a killed recorder has left beside it. */
  public static OpenedRecording open(FileBytes file, ScanProgress progress) throws RecordingException {
    DamageList damages = new DamageList();
    Optional<FileBytes> log = log(file, damages);
    boolean opened = false;
    try {
      SqlitePages pages = SqlitePages.open(file, log, damages);
      OpenedRecording recording = new DatabaseOpener(file, pages, damages).read(pages, progress);
      opened = true;
      return new OpenedRecording(file.path(), FORMAT, false, recording.index(), recording.source(),
          recording.damages(), () -> {
            file.close();
            log.ifPresent(FileBytes::close);
          });
    } catch (MalformedRecord e) {
      throw new RecordingException(file.path(), 0, "this is no database that can be read: " + e.getMessage());
    } finally {
      if (!opened) {
        log.ifPresent(FileBytes::close);
      }
    }
  }

  private static Optional<FileBytes> log(FileBytes file, DamageList damages) {
    Path log = beside(file, "-wal");
    if (Files.exists(beside(file, "-journal"))) {
      damages.add(0, "the recorder was killed while it wrote (there is a journal beside the file): what it wrote last"
          + " may be missing or wrong");
    }
    if (!Files.exists(log)) {
      return Optional.empty();
    }
    try {
      return Optional.of(FileBytes.open(log));
    } catch (RecordingException e) {
      damages.add(0, "what was written last is missing: " + e.getMessage());
      return Optional.empty();
    }
  }

  private static Path beside(FileBytes file, String ending) {
    return file.path().resolveSibling(file.path().getFileName() + ending);
  }

  private OpenedRecording read(SqlitePages pages, ScanProgress progress) throws RecordingException {
    SqliteTable messages = need("messages");
    SqliteTable topics = need("topics");
    Optional<SqliteTable> definitions = tables.table("message_definitions");
    if (definitions.isPresent()) {
      definitions(definitions.get());
    }
    topics(topics);
    List<RowRange> ranges = new ArrayList<>();
    MessageColumns columns = new MessageColumns(messages, numbers);
    MessageScan scan = new MessageScan(columns, index, ranges, pages.mostBytes(), progress);
    messages.walk(scan);
    scan.close();
    DatabaseSource source = new DatabaseSource(file, pages, columns, ranges, damages);
    return OpenedRecording.of(file, FORMAT, false, index, source, damages);
  }

  private SqliteTable need(String name) throws RecordingException {
    return tables.table(name).orElseThrow(() -> new RecordingException(file.path(), 0,
        "this is a database of SQLite, and none of rosbag2: it has no table '" + name + "'"
            + damages.all().stream().findFirst().map(each -> " (" + each + ")").orElse("")));
  }

  private void definitions(SqliteTable table) throws RecordingException {
    int type = table.column("topic_type");
    int encoding = table.column("encoding");
    int text = table.column("encoded_message_definition");
    table.walk((page, number, row) -> {
      SqliteValues values = row.values(table.pages(), MOST_DEFINITION);
      String name = values.text(type, table.charset());
      String definition = values.text(text, table.charset());
      if (!definition.isEmpty()) {
        schemas.put(name, new RecordedSchema(name, values.text(encoding, table.charset()),
            definition.getBytes(StandardCharsets.UTF_8)));
      }
    });
  }

  private void topics(SqliteTable table) throws RecordingException {
    table.walk((page, number, row) -> {
      SqliteValues values = row.values(table.pages(), MOST_DEFINITION);
      String type = text(table, values, "type");
      Map<String, String> notes = new LinkedHashMap<>();
      note(notes, "offered_qos_profiles", text(table, values, "offered_qos_profiles"));
      note(notes, "topic_type_hash", text(table, values, "type_description_hash"));
      int channel = numbers.size();
      if (numbers.putIfAbsent(row.id(), channel) == null) {
        index.channels().put(channel, new RecordedChannel(channel, text(table, values, "name"),
            text(table, values, "serialization_format"),
            schemas.getOrDefault(type, new RecordedSchema(type, "", new byte[0])), notes));
      }
    });
  }

  private static String text(SqliteTable table, SqliteValues values, String column) throws MalformedRecord {
    return values.text(table.column(column), table.charset());
  }

  private static void note(Map<String, String> notes, String name, String value) {
    if (!value.isEmpty()) {
      notes.put(name, value);
    }
  }
}
