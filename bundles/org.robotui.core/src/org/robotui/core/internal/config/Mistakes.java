package org.robotui.core.internal.config;

import java.util.AbstractList;
import java.util.ArrayList;
import java.util.List;
import org.robotui.api.host.Problem;

/** What is wrong with a file, up to a number from which on nobody reads on and a hostile file would take all memory. */
final class Mistakes extends AbstractList<Problem> {
  /** The most that are kept. */
  static final int MOST = 1000;

  private final List<Problem> problems = new ArrayList<>();

  /** There are more than are kept: reading ends. */
  static final class TooMany extends RuntimeException {
    private static final long serialVersionUID = 1L;

    TooMany() {
      super("more than " + MOST + " mistakes; the others are not looked at", null, false, false);
    }
  }

  @Override
  public Problem get(int index) {
    return problems.get(index);
  }

  @Override
  public int size() {
    return problems.size();
  }

  @Override
  public void add(int index, Problem problem) {
    if (problems.size() >= MOST) {
      throw new TooMany();
    }
    problems.add(index, problem);
  }
}
