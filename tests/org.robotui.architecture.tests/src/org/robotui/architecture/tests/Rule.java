package org.robotui.architecture.tests;

import java.util.stream.Stream;

/** Something that holds for the whole repository. */
interface Rule {

  /** The rule as a sentence; it is the name of its test. */
  String statement();

  /** All places in the repository where the rule does not hold. */
  Stream<Violation> violations(Repository repository);
}
