package org.robotui.rfic.recording.internal.find;

import java.util.List;
import java.util.stream.Stream;
import org.robotui.rfic.recording.internal.time.SearchableHistory;

/** Names what could have been written. */
public final class SourceWords {
  private static final int MOST = 20;

  private SourceWords() {}

  /**
   * Says that recordings have nothing of what a condition names.
   *
   * @param histories the recordings
   * @return a sentence for users, with what they have
   */
  public static String nothing(Stream<SearchableHistory> histories) {
    List<String> names = histories.flatMap(each -> each.candidates().stream()).map(each -> each.id().port()).distinct()
        .sorted().toList();
    String more = names.size() > MOST ? " and " + (names.size() - MOST) + " more" : "";
    return "nothing of what the condition names was recorded"
        + (names.isEmpty() ? "" : "; there is " + String.join(", ", names.stream().limit(MOST).toList()) + more);
  }
}
