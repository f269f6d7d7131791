package org.robotui.architecture.tests;

import java.util.stream.Stream;

/** A file that does not fit on a few screens does too much. */
final class SizeRule implements Rule {

  private static final int MOST_LINES = 400;

  @Override
  public String statement() {
    return "no source has more than " + MOST_LINES + " lines";
  }

  @Override
  public Stream<Violation> violations(Repository repository) {
    return repository.sources()
        .filter(source -> source.lines() > MOST_LINES)
        .map(source -> new Violation(source.where(), source.lines() + " lines"));
  }
}
