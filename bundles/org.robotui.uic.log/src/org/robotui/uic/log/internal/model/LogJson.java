package org.robotui.uic.log.internal.model;

import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;
import org.robotui.ui.show.RecordJson;

/** Entries of the log as JSON. */
public final class LogJson {
  private LogJson() {}

  /** The newest entry of a line, with how many are alike. */
  public static String of(LogLine line) {
    Entry entry = line.last();
    Map<String, FieldValue> fields = new LinkedHashMap<>();
    fields.put("stamp", new FieldValue.Time(entry.nanos()));
    fields.put("level", new FieldValue.Text(entry.severity().name().toLowerCase(Locale.ROOT)));
    fields.put("node", new FieldValue.Text(entry.origin()));
    fields.put("message", new FieldValue.Text(entry.message()));
    fields.put("location", new FieldValue.Text(entry.location()));
    fields.put("count", new FieldValue.Num(line.count(), Integer.toString(line.count())));
    return RecordJson.of(new MapRecord("log", fields));
  }
}
