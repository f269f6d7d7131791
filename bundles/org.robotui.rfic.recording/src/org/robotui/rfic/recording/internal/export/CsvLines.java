package org.robotui.rfic.recording.internal.export;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;

/**
 * Messages as rows of one table, which has the columns that any of them has.
 *
 * <p>Source: RFC 4180, with line feeds alone.
 */
final class CsvLines implements MessageLines {
  private final TableColumns columns = new TableColumns();

  @Override
  public boolean learns() {
    return true;
  }

  @Override
  public void learn(DynamicRecord message) {
    columns.learn(new FieldValue.Nested(message));
  }

  @Override
  public String head() {
    List<String> names = new ArrayList<>(List.of("time [s]", "elapsed [s]"));
    columns.names(names);
    return row(names);
  }

  @Override
  public String line(long time, long elapsed, DynamicRecord message) {
    List<String> cells = new ArrayList<>(List.of(MessageLines.seconds(time), MessageLines.seconds(elapsed)));
    columns.cells(new FieldValue.Nested(message), cells);
    return row(cells);
  }

  private static String row(List<String> cells) {
    return cells.stream().map(CsvLines::cell).collect(Collectors.joining(",", "", "\n"));
  }

  private static String cell(String text) {
    boolean plain = text.chars().noneMatch(c -> c == ',' || c == '"' || c == '\n' || c == '\r');
    return plain ? text : '"' + text.replace("\"", "\"\"") + '"';
  }

  @Override
  public String note() {
    return columns.note();
  }
}
