package org.robotui.uic.log.internal.view;

import java.nio.file.Path;
import java.util.List;
import org.robotui.uic.log.internal.model.LogFilter;
import org.robotui.uic.log.internal.model.LogLine;

/** Remembers which filters were asked for. */
record Asked(List<LogFilter> filters) implements LogHands {
  @Override
  public void filter(LogFilter next) {
    filters.add(next);
  }

  @Override
  public void showAll() {
    filters.add(LogFilter.ALL);
  }

  @Override
  public void pause(boolean on) {
    throw new AssertionError("nobody asked for a pause");
  }

  @Override
  public void clear() {
    throw new AssertionError("nobody asked for clearing");
  }

  @Override
  public void nodes(boolean shown) {
    throw new AssertionError("nobody asked for the list of nodes");
  }

  @Override
  public void save(List<LogLine> lines, Path file) {
    throw new AssertionError("nobody asked for a file");
  }
}
