package org.robotui.rfic.recording.internal.find;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * What became of a scan.
 *
 * @param values how many values were looked at
 * @param unreadable how many messages could not be read
 * @param problem why, of the first one
 * @param neverKnown why it could never be told whether the condition holds
 */
public record ScanOutcome(long values, long unreadable, Optional<String> problem, Optional<String> neverKnown) {
  /**
   * Whether all messages could be read.
   *
   * @return false where something is missing
   */
  public boolean isWhole() {
    return problem.isEmpty();
  }

  /**
   * Why nothing can have been found, whatever is in some recordings.
   *
   * @param outcomes of all of them
   * @return the reason; none where it was known of any recording whether the condition holds
   */
  public static Optional<String> neverKnown(List<ScanOutcome> outcomes) {
    return outcomes.stream().anyMatch(each -> each.neverKnown().isEmpty()) ? Optional.empty()
        : outcomes.stream().flatMap(each -> each.neverKnown().stream()).findFirst();
  }

  /**
   * What users should know of it.
   *
   * @return sentences
   */
  public List<String> problems() {
    List<String> all = new ArrayList<>();
    problem.ifPresent(first -> all.add(unreadable == 0 ? first
        : (unreadable == 1 ? "a message" : unreadable + " messages") + " could not be read, the first: " + first));
    neverKnown.ifPresent(why -> all.add("it was never known whether the condition holds: " + why));
    return all;
  }
}
