package org.robotui.rfic.recording.internal.export;

import java.util.LinkedHashMap;
import java.util.Map;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.RecordTree;
import org.robotui.web.tree.JsonText;

/** Messages as objects of JSON, with all that they have. Times are numbers of nanoseconds. */
final class JsonLines implements MessageLines {
  @Override
  public boolean learns() {
    return false;
  }

  @Override
  public void learn(DynamicRecord message) {
    // each line says what it has
  }

  @Override
  public String head() {
    return "";
  }

  @Override
  public String line(long time, long elapsed, DynamicRecord message) {
    Map<String, Object> line = new LinkedHashMap<>();
    line.put("time", time);
    line.put("elapsed", elapsed / 1e9);
    line.put("message", RecordTree.of(message));
    return JsonText.write(line) + "\n";
  }

  @Override
  public String note() {
    return "";
  }
}
