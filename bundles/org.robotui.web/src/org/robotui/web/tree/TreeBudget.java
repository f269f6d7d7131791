package org.robotui.web.tree;

/** Bounds what a tree takes in memory: a few bytes of a message may become many objects. For one tree. */
final class TreeBudget {

  static final int MAX_DEPTH = 64;
  private static final int MAX_VALUES = 1_000_000;

  private int values;

  /** One more value that is an object of its own. */
  void value() throws TreeException {
    if (++values > MAX_VALUES) {
      throw new TreeException("more than " + MAX_VALUES + " values");
    }
  }

  static void depth(int depth) throws TreeException {
    if (depth > MAX_DEPTH) {
      throw new TreeException("nested more than " + MAX_DEPTH + " deep");
    }
  }
}
