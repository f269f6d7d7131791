package org.robotui.uic.team.internal.model;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.Input;
import org.robotui.api.port.SourceId;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;
import org.robotui.ui.Health;

/**
 * What robots do, by the states of their goals as actions tell them ({@code actionlib_msgs/GoalStatusArray}). Worker
 * thread.
 */
final class Tasks {
  private static final List<String> WORDS =
      List.of("waiting", "on its way", "given up for another", "done", "failed", "refused", "ending",
          "taken back", "taken back", "lost");
  private static final int DONE = 3;
  private static final int FAILED = 4;
  private static final int REFUSED = 5;
  private static final int LOST = 9;

  /**
   * What a robot does.
   *
   * @param words for users
   * @param health what to think of it
   */
  record Task(String words, Health health) {
    static final Task NONE = new Task("", Health.NONE);
  }

  private final Input<DynamicRecord> input;
  private final String name;
  private Set<SourceId> chosen = Set.of();

  /** Takes the streams whose names end so. */
  Tasks(Input<DynamicRecord> input, String name) {
    this.input = input;
    this.name = name;
  }

  /** Asks for the streams that there are now. */
  void choose() {
    Set<SourceId> wanted = new HashSet<>();
    input.candidates().stream().map(Input.Candidate::id)
        .filter(id -> id.port().equals(name) || id.port().endsWith("/" + name)).forEach(wanted::add);
    if (!wanted.equals(chosen)) {
      chosen = wanted;
      input.choose(wanted);
    }
    input.drain(e -> {});
  }

  /** What a robot does, none where it does not tell. */
  Optional<Task> of(Member member) {
    return chosen.stream().filter(member::has).findFirst().flatMap(input::latest).map(Envelope::record)
        .map(Tasks::read);
  }

  private static Task read(DynamicRecord record) {
    Optional<FieldValue> list = record.field("status_list");
    if (list.isEmpty() || !(list.get() instanceof FieldValue.Items items) || items.values().isEmpty()) {
      return Task.NONE;
    }
    return items.values().getLast() instanceof FieldValue.Nested last ? state(last.value()) : Task.NONE;
  }

  private static Task state(DynamicRecord goal) {
    int state = goal.field("status").filter(FieldValue.Num.class::isInstance)
        .map(v -> (int) ((FieldValue.Num) v).value()).orElse(-1);
    String text = goal.field("text").filter(FieldValue.Text.class::isInstance).map(v -> ((FieldValue.Text) v).value())
        .orElse("").strip();
    String word = state >= 0 && state < WORDS.size() ? WORDS.get(state) : "";
    boolean bad = state == FAILED || state == REFUSED || state == LOST;
    return new Task(text.isEmpty() ? word : text, bad ? Health.WARNING : state == DONE ? Health.OK : Health.NONE);
  }
}
