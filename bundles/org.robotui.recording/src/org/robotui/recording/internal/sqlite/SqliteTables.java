package org.robotui.recording.internal.sqlite;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.robotui.recording.RecordingException;
import org.robotui.recording.internal.chunk.DamageList;

/** The tables of a database. */
public final class SqliteTables {

  private static final int ROOT = 1;
  private static final int MOST_BYTES = 1 << 20;
  private static final List<String> CONSTRAINTS = List.of("PRIMARY", "UNIQUE", "CHECK", "FOREIGN", "CONSTRAINT");

  private final Map<String, SqliteTable> tables = new HashMap<>();

  public SqliteTables(SqlitePages pages, DamageList damages) throws RecordingException {
    // type, name, tbl_name, rootpage, sql
    new SqliteTable(pages, damages, ROOT, List.of()).walk((page, index, row) -> {
      SqliteValues values = row.values(pages, MOST_BYTES);
      if (values.text(0, pages.charset()).equals("table")) {
        List<String> columns = columns(values.text(4, pages.charset()));
        tables.put(values.text(1, pages.charset()), new SqliteTable(pages, damages, values.whole(3), columns));
      }
    });
  }

  public Optional<SqliteTable> table(String name) {
    return Optional.ofNullable(tables.get(name));
  }

  /** The names in what made a table: the first word of each of its parts, but for constraints. */
  static List<String> columns(String sql) {
    List<String> columns = new ArrayList<>();
    int depth = 0;
    StringBuilder part = new StringBuilder();
    for (char c : sql.toCharArray()) {
      depth += c == '(' ? 1 : c == ')' ? -1 : 0;
      boolean begins = c == '(' && depth == 1;
      if (begins || depth == 0 || depth == 1 && c == ',') {
        if (!begins && !part.isEmpty()) {
          column(part.toString().strip(), columns);
        }
        part.setLength(0);
      } else {
        part.append(c);
      }
    }
    return columns;
  }

  private static void column(String part, List<String> columns) {
    String first = part.split("\\s", 2)[0];
    String name = first.replaceAll("[\"`\\[\\]']", "");
    if (!name.isEmpty() && !CONSTRAINTS.contains(first.toUpperCase(Locale.ROOT))) {
      columns.add(name);
    }
  }
}
