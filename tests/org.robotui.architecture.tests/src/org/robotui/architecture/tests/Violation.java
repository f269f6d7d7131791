package org.robotui.architecture.tests;

/** One place where a rule is broken: where (a path or a bundle), and what is wrong there. */
record Violation(String where, String what) {

  @Override
  public String toString() {
    return where + ": " + what;
  }
}
