package org.robotui.condition;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import org.robotui.api.port.Input;
import org.robotui.data.status.Diagnostics;

/** A part of the robot reports another level than before. What is seen first is no change. */
final class LevelChangeCondition implements Condition {
  private final String part;
  private final Map<String, Diagnostics.Level> before = new HashMap<>();

  /** Of parts whose name contains the words, empty for any. */
  LevelChangeCondition(String part) {
    this.part = part;
  }

  @Override
  public Predicate<Input.Candidate> needs() {
    return DiagnosticsCondition.NEEDS;
  }

  @Override
  public boolean momentary() {
    return true;
  }

  @Override
  public Verdict check(Signals signals, boolean active) {
    List<Diagnostics.Item> items = DiagnosticsCondition.items(signals, part);
    List<String> names = new ArrayList<>();
    List<String> words = new ArrayList<>();
    for (Diagnostics.Item item : items) {
      Diagnostics.Level old = before.put(item.name(), item.level());
      if (old != null && old != item.level()) {
        names.add(item.name());
        words.add(DiagnosticsCondition.words(item) + " (was " + old + ")");
      }
    }
    return names.isEmpty() ? new Verdict.Fails()
        : new Verdict.Holds(String.join(", ", names), names.size() == 1 ? "reports" : "report",
            String.join(", ", words));
  }
}
