package org.robotui.uic.connections.internal.model;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import org.robotui.ui.Health;

/**
 * Which lines are wanted.
 *
 * @param problems whether only what is wrong is wanted
 * @param ruic the only RUIC wanted, or none for all
 * @param words all of which must be in a line, in lower case
 */
public record Filter(boolean problems, Optional<String> ruic, List<String> words) {
  /** Everything is wanted. */
  public static final Filter ALL = of(false, "", "");

  /** Copies the list. */
  public Filter {
    words = List.copyOf(words);
  }

  /** From settings and what is typed. */
  public static Filter of(boolean problems, String ruic, String search) {
    return new Filter(problems, Optional.of(ruic).filter(name -> !name.isBlank()),
        Stream.of(search.toLowerCase(Locale.ROOT).split("\\s+")).filter(word -> !word.isEmpty()).toList());
  }

  /** Whether lines are left out, other than by the choice of a robot. */
  public boolean narrows() {
    return problems || !words.isEmpty();
  }

  boolean admits(String name) {
    return ruic.isEmpty() || ruic.get().equals(name);
  }

  /** Whether a line is wanted for its own sake. */
  boolean fits(ConnectionLine line) {
    // what waits is no problem, but who looks for one wants to see it
    boolean waits = line instanceof ConnectionLine.RobotPort && line.health() == Health.WAITING;
    if (problems && !line.isProblem() && !waits) {
      return false;
    }
    if (words.isEmpty()) {
      return true;
    }
    String text = (line.ruic() + "\n" + line.key() + "\n" + line.details()).toLowerCase(Locale.ROOT);
    return words.stream().allMatch(text::contains);
  }
}
